// `mortise list`.
#pragma once

#include <string>

namespace mortise {

/// Prints the choices of one kind, or of all kinds when `what` is empty. Throws InputError for an unknown kind.
void list_options(const std::string& what, const std::string& cases_root);

}  // namespace mortise
