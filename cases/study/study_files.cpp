#include "mortise/cases/study/study_files.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

/// Runs the script by an interpreter; false where it did not work.
bool plot(const char* python, const std::string& script, const std::string& directory) {
  const pid_t child = fork();
  if (child == 0) {
    const int log = open((directory + "/plot.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(log, STDERR_FILENO);
    execlp(python, python, script.c_str(), directory.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// matplotlib is the system's, which need not be the first Python in the path.
bool plot(const std::string& script, const std::string& directory) {
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (plot(python, script, directory)) {
      std::error_code ignored;
      std::filesystem::remove(directory + "/plot.log", ignored);
      return true;
    }
  return false;
}

}  // namespace

void write_study(const StudyFiles& files, const std::string& directory, const std::string& cases_root) {
  std::string text, paper;
  for (const Table& table : files.tables) {
    text += (text.empty() ? "" : "\n") + markdown(table);
    paper += (paper.empty() ? "" : "\n") + latex(table);
  }
  write_file(directory + "/study.json",
             files.data.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
  write_file(directory + "/study.csv", csv(files.values));
  write_file(directory + "/study.md", text);
  write_file(directory + "/study.tex", paper);
  std::printf("\n%s\ntables    %s/study.md, study.tex, study.csv, study.json\n", text.c_str(), directory.c_str());
  std::fflush(stdout);
  const std::string script = cases_root + "/study/plot.py";
  if (!plot(script, directory))
    std::fprintf(stderr,
                 "mortise: no picture of this study: python3 with matplotlib could not make one, see %s/plot.log\n",
                 directory.c_str());
  else
    std::printf("picture   %s/study.png\n", directory.c_str());
}

}  // namespace mortise
