// Failures that all ranks know of: then all end alike, and the user reads one sentence once.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "mortise/grids/core/parallel.hpp"

namespace mortise {

/// Thrown by every rank at the same place. What one rank alone throws leaves the others waiting for it.
struct AgreedFailure : std::runtime_error {
  AgreedFailure(const std::string& sentence, int exit_status) : std::runtime_error(sentence), status(exit_status) {}
  int status;  // of the program
};

/// Runs `action`, which communicates with nobody, on every rank. When it throws InputError, EnvironmentError or an
/// error of the file system or memory on some rank, every rank throws the AgreedFailure of the lowest such rank.
/// Collective.
void agree(const Communicator& comm, const std::function<void()>& action);

}  // namespace mortise
