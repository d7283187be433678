#include "mortise/cases/driver/output_directory.hpp"

#include <unistd.h>

#include <filesystem>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace fs = std::filesystem;
namespace {

constexpr const char* files_of_a_run[] = {"summary.json", "mortise.xdmf", "bodies.csv", "probes.csv", "checkpoint.h5", "fields", "frames"};

bool holds_a_run(const fs::path& directory) {
  for (const char* file : files_of_a_run)
    if (fs::exists(directory / file)) return true;
  return false;
}

}  // namespace

void check_output_directory(const std::string& directory, bool overwrite, bool restart) {
  std::error_code error;
  fs::path existing = fs::absolute(directory);
  if (fs::exists(existing, error) && !fs::is_directory(existing, error)) throw InputError("the output \"" + directory + "\" is a file, not a directory");
  if (!overwrite && !restart && holds_a_run(existing))
    throw InputError("the output directory \"" + directory + "\" holds a run already; choose another with --output or replace it with --overwrite");
  while (!fs::exists(existing, error) && existing.has_parent_path() && existing != existing.parent_path()) existing = existing.parent_path();
  if (!fs::is_directory(existing, error) || access(existing.c_str(), W_OK | X_OK) != 0)
    throw InputError("the output directory \"" + directory + "\" cannot be written (no permission in \"" + existing.string() + "\")");
}

void prepare_output_directory(const std::string& directory, bool overwrite) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw InputError("the output directory \"" + directory + "\" cannot be made: " + error.message());
  if (!overwrite) return;
  for (const char* file : files_of_a_run) fs::remove_all(fs::path(directory) / file, error);
  if (error) throw InputError("the earlier run in \"" + directory + "\" cannot be removed: " + error.message());
}

}  // namespace mortise
