// What program made the results.
#pragma once

#include <string>

namespace mortise {

struct Provenance {
  std::string version;   // of mortise
  std::string git;       // commit the program was built from; "unknown" outside a repository
  bool dirty = false;    // whether the sources differed from that commit
  std::string compiler;  // name and version
  std::string flags;     // compiler flags
};

/// Of the running program. The build gives the parts as macros MORTISE_VERSION, MORTISE_GIT, MORTISE_COMPILER,
/// MORTISE_FLAGS (strings) and MORTISE_GIT_DIRTY (0 or 1).
Provenance provenance();

}  // namespace mortise
