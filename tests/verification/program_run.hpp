// Starts the program as a user does, without a shell, and compares what it leaves behind.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "mortise/grids/output/atomic_file.hpp"
#include "unit/grids/output/scratch_folder.hpp"
#include "verification/words.hpp"

namespace mortise::testing {

using test::ScratchFolder;
using Arguments = Words;

/// Two bodies in a uniform stream, with a probe between them; lines are counted from 1.
inline const std::string two_bodies =
    "title = \"two bodies in a stream\"\n"
    "[grid]\n"
    "factor = 4.0\n"
    "low = [-1.0, -1.0]\n"
    "high = [1.0, 1.0]\n"
    "[time]\n"
    "end = 0.1\n"
    "[initial]\n"
    "kind = \"uniform\"\n"
    "state = [1.0, 0.5, 0.0, 1.0]\n"
    "[output]\n"
    "frames = 1\n"
    "[[bodies]]\n"  // line 13
    "name = \"first\"\n"
    "shape = \"circle\"\n"
    "radius = 0.2\n"
    "position = [-0.4, 0.0]\n"
    "density = 1.0\n"
    "[[bodies]]\n"  // line 19
    "name = \"second\"\n"
    "shape = \"polygon\"\n"
    "corners = [[-0.2, -0.2], [0.2, -0.2], [0.0, 0.2]]\n"
    "fillet = 0.05\n"
    "position = [0.4, 0.0]\n"
    "density = 1.0\n";

/// How to start the program.
struct Launch {
  int ranks = 0;                     // 0: without mpiexec
  std::string folder = ".";          // working directory
  rlim_t file_size = RLIM_INFINITY;  // bytes: files cannot grow beyond, as on a full disk
};

struct Outcome {
  int status = -1;  // exit status; −1: ended by a signal, or by us after a minute
  std::string output, errors;
};

/// The program, running. Ended when destroyed.
class Program {
 public:
  explicit Program(const Arguments& arguments, const Launch& launch = {})
      : Program(starter(launch), arguments, launch) {}
  /// `starter`: the words before the arguments, the program among them.
  Program(Arguments starter, const Arguments& arguments, const Launch& launch) {
    starter.insert(starter.end(), arguments.begin(), arguments.end());
    start(starter, launch);
  }
  ~Program() {
    if (process_ <= 0) return;
    kill();
    waitpid(process_, nullptr, 0);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void kill() { ::kill(process_, SIGKILL); }

  Outcome wait() {
    int status = 0;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (waitpid(process_, &status, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > deadline) kill();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    process_ = 0;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(capture_ / "output"),
            read_file(capture_ / "errors")};
  }

 private:
  static Arguments starter(const Launch& launch) {
    if (launch.ranks == 0) return {MORTISE_PROGRAM};
    return {"mpiexec", "--oversubscribe", "-n", std::to_string(launch.ranks), MORTISE_PROGRAM};
  }
  void start(Arguments& words, const Launch& launch) {
    std::vector<char*> raw;
    for (std::string& word : words) raw.push_back(word.data());
    raw.push_back(nullptr);
    const std::string output = capture_ / "output", errors = capture_ / "errors";
    process_ = fork();
    if (process_ != 0) return;
    const rlimit limit{launch.file_size, launch.file_size};
    const bool ready = setrlimit(RLIMIT_FSIZE, &limit) == 0 && chdir(launch.folder.c_str()) == 0 &&
                       dup2(open(output.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO) >= 0 &&
                       dup2(open(errors.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO) >= 0;
    if (ready) execvp(raw.front(), raw.data());
    _exit(127);
  }

  ScratchFolder capture_;
  pid_t process_ = 0;
};

inline Outcome run_program(const Arguments& arguments, const Launch& launch = {}) {
  return Program(arguments, launch).wait();
}

inline int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

inline nlohmann::json summary_of(const std::string& folder) {
  return nlohmann::json::parse(read_file(folder + "/summary.json"));
}

/// Paths of all files in the folder, relative to it.
inline std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& item : std::filesystem::recursive_directory_iterator(folder))
    if (item.is_regular_file()) names.insert(std::filesystem::relative(item.path(), folder).string());
  return names;
}

/// What differs between two output directories: names of files that are not there twice with the same bytes, and
/// "summary.json:key". Times and the number of ranks always may differ; `free` names more keys and files that may.
inline std::vector<std::string> differences(const std::string& a, const std::string& b,
                                            const std::set<std::string>& free = {}) {
  std::set<std::string> names = files_in(a), others = files_in(b);
  names.merge(others);
  std::vector<std::string> different;
  for (const std::string& name : names) {
    if (name == "summary.json" || free.count(name)) continue;
    const bool both = std::filesystem::exists(a + "/" + name) && std::filesystem::exists(b + "/" + name);
    if (!both || read_file(a + "/" + name) != read_file(b + "/" + name)) different.push_back(name);
  }
  const std::set<std::string> always = {"wall_seconds", "cell_updates_per_second", "phases", "memory_bytes", "ranks"};
  const nlohmann::json left = summary_of(a), right = summary_of(b);
  for (const auto& [key, value] : left.items())
    if (!always.count(key) && !free.count(key) && (!right.contains(key) || right[key] != value))
      different.push_back("summary.json:" + key);
  return different;
}

using CsvRow = std::map<std::string, std::string>;

/// Rows by column name. Fields are not quoted in the files of these tests.
inline std::vector<CsvRow> csv_rows(const std::string& path) {
  const std::vector<std::string> all = lines(read_file(path));
  const auto fields = [](const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
    return words;
  };
  const std::vector<std::string> columns = fields(all.at(0));
  std::vector<CsvRow> rows;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const std::vector<std::string> values = fields(all[k]);
    CsvRow row;
    for (std::size_t c = 0; c < columns.size(); ++c) row[columns[c]] = values.at(c);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace mortise::testing
