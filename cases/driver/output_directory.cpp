#include "mortise/cases/driver/output_directory.hpp"

#include <unistd.h>

#include <filesystem>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace fs = std::filesystem;
namespace {

constexpr const char* files_of_a_run[] = {"summary.json", "mortise.xdmf", "bodies.csv", "probes.csv", "solids.csv", "tracers.csv", "checkpoint.h5", "fields", "frames"};

bool holds_a_run(const fs::path& directory) {
  for (const char* file : files_of_a_run)
    if (fs::exists(directory / file)) return true;
  return false;
}

/// What a killed run was writing.
void remove_unfinished(const fs::path& directory) {
  std::error_code ignored;
  for (const fs::path& folder : {directory, directory / "fields", directory / "frames"})
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (entry.path().extension() == temporary_name("")) fs::remove(entry.path(), ignored);
}

}  // namespace

void check_output_directory(const std::string& directory, bool overwrite, bool restart) {
  std::error_code error;
  fs::path existing = fs::absolute(directory);
  if (fs::exists(existing, error) && !fs::is_directory(existing, error)) throw InputError("the output \"" + directory + "\" is a file, not a directory");
  if (!overwrite && !restart && holds_a_run(existing))
    throw InputError("the output directory \"" + directory + "\" holds a run already; choose another with --output or replace it with --overwrite");
  while (!fs::exists(existing, error) && existing.has_parent_path() && existing != existing.parent_path()) existing = existing.parent_path();
  const std::string refusal = "the output directory \"" + directory + "\" cannot be written: \"" + existing.string() + "\" ";
  if (!fs::is_directory(existing, error)) throw InputError(refusal + "is not a directory; choose another with --output");
  if (access(existing.c_str(), W_OK | X_OK) != 0) throw InputError(refusal + "may not be written to; choose another with --output");
}

void prepare_output_directory(const std::string& directory, bool overwrite) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw InputError("the output directory \"" + directory + "\" cannot be made: " + error.message() + "; choose another with --output");
  if (!overwrite) return remove_unfinished(directory);
  for (const char* file : files_of_a_run) fs::remove_all(fs::path(directory) / file, error);
  if (error) throw InputError("the earlier run in \"" + directory + "\" cannot be removed: " + error.message());
}

}  // namespace mortise
