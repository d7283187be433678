// Two kinds of failure. What the user can mend is an exception that ends in one clear sentence and an exit
// status of the program (CONTRACT: 2 input, 3 numerics, 4 environment). What only we can mend is an assertion.
#pragma once

#include <stdexcept>
#include <string>

namespace mortise {

/// The input is wrong: nothing was run, nothing was written. The message is one sentence with the place
/// (file, line, column, key), the value seen, what is allowed and the nearest valid name, as far as known.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The computation failed: the message names the first bad cell (grid, index, position, state).
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The surroundings failed: disk full, unreadable restart, unwritable directory during a run.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Prints expression, place and rank to stderr and aborts. Called by MORTISE_ASSERT only.
[[noreturn]] void assertion_failed(const char* expression, const char* file, int line, const std::string& state);

}  // namespace mortise

#ifdef MORTISE_ASSERTIONS
#define MORTISE_ASSERT(expression, state) \
  ((expression) ? void(0) : ::mortise::assertion_failed(#expression, __FILE__, __LINE__, (state)))
#else
#define MORTISE_ASSERT(expression, state) void(0)
#endif
