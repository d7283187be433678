// The command line of `mortise`.
#pragma once

namespace mortise {

/// Runs the program; MPI must be initialised. Returns the exit status: 0 done, 2 the input is wrong, 3 the computation failed, 4 the
/// environment failed. Errors go to stderr, one clear sentence first.
int program(int argc, const char* const* argv);

}  // namespace mortise
