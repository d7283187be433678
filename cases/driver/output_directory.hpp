// The directory a run writes to.
#pragma once

#include <string>

namespace mortise {

/// Throws InputError when the directory holds a run already (and neither overwriting nor restarting), or cannot be written. Makes nothing.
void check_output_directory(const std::string& directory, bool overwrite, bool restart);

/// Makes the directory; `overwrite`: removes what an earlier run wrote there, otherwise only what it left unfinished when it
/// was killed. Throws InputError when that cannot be done.
void prepare_output_directory(const std::string& directory, bool overwrite);

}  // namespace mortise
