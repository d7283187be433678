// `mortise render`: pictures from the field files of a finished run.
#pragma once

#include <string>

namespace mortise {

/// Writes frames/<field>_NNNN.png for every step in the directory; returns 0. Throws InputError when there is no run, or no such field.
int render_run(const std::string& directory, const std::string& field);

}  // namespace mortise
