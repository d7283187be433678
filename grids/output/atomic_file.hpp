// Files that appear whole or not at all: written under a temporary name beside the target, then renamed over it.
#pragma once

#include <string>
#include <string_view>

namespace mortise {

/// The name under which `path` is written before it is published.
std::string temporary_name(const std::string& path);

/// Creates the folder (and its parents) if it is not there. Throws EnvironmentError.
void make_folder(const std::string& folder);

/// Whether a file must survive a loss of power once the call returns (checkpoints), which costs a wait for the disk.
enum class Durable { no, yes };

/// Renames temporary_name(path) to `path`, after bringing it to the disk if durable. Throws EnvironmentError.
void publish(const std::string& path, Durable durable = Durable::no);

/// Replaces the file at `path` by `content`. Throws EnvironmentError (disk full, unwritable folder); then the
/// old file, if any, is untouched and no temporary file is left.
void write_file(const std::string& path, std::string_view content, Durable durable = Durable::no);

/// The whole file. Throws EnvironmentError.
std::string read_file(const std::string& path);

/// Shortest decimal form that reads back to the same double; independent of the locale. "nan", "inf", "-inf".
std::string shortest(double value);

}  // namespace mortise
