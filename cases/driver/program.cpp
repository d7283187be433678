#include "mortise/cases/driver/program.hpp"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "mortise/cases/driver/agreement.hpp"
#include "mortise/cases/driver/command_line_errors.hpp"
#include "mortise/cases/driver/list.hpp"
#include "mortise/cases/driver/render_run.hpp"
#include "mortise/cases/driver/run_case.hpp"
#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/study/command.hpp"
#include "mortise/cases/summary/provenance.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr const char* exit_statuses =
    "Exit status: 0 done; 2 the input is wrong, nothing was run or written; 3 the computation failed, its last\n"
    "checkpoint is kept; 4 the surroundings failed (disk full, unreadable restart).\n"
    "Example: mortise run shock_rigid_sticks --set grid.factor=4 --frames 20 --output sticks";

struct Arguments {
  std::string case_name, directory, what;
  std::vector<std::string> overrides;
  std::string field;
  RunOptions run;
  std::function<int(const std::string& cases_root)> study;
};

/// Where the shipped cases are: beside the sources the program was built from, or MORTISE_CASES.
std::string cases_root() {
  if (const char* root = std::getenv("MORTISE_CASES")) return root;
  return MORTISE_CASES_ROOT;
}

CLI::App* add_case_command(CLI::App& app, const char* name, const char* meaning, Arguments& arguments) {
  CLI::App* command = app.add_subcommand(name, meaning);
  command->add_option("case", arguments.case_name, "name of a shipped case, or path of a TOML file")->required();
  command->add_option("--set", arguments.overrides, "key=value: replace a value of the case file (dotted keys, arrays by index)")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  return command;
}

void add_run(CLI::App& app, Arguments& arguments) {
  CLI::App* run = add_case_command(app, "run", "run a case", arguments);
  run->add_option("--output", arguments.run.output, "directory to write to; default: output/<case>")->type_name("DIR");
  run->add_option("--until", arguments.run.until, "end at this time, with a checkpoint to go on from")->type_name("T")->check(positive_number());
  run->add_option("--frames", arguments.run.frames, "pictures over the run, besides t = 0")->type_name("N")->check(count_up_to(100000));
  run->add_option("--restart", arguments.run.restart, "continue the run in this directory from its last checkpoint")->type_name("DIR");
  run->add_flag("--no-skip", arguments.run.no_skip, "compute everything, also what cannot change");
  run->add_flag("--quiet", arguments.run.quiet, "print nothing but errors");
  run->add_flag("--overwrite", arguments.run.overwrite, "replace the run in the output directory");
}

int dispatch(CLI::App& app, const Arguments& arguments) {
  const Communicator comm;
  if (app.got_subcommand("study")) {
    if (comm.size() > 1) throw InputError("a study starts its own processes, one a core: run it without mpirun");
    return arguments.study(cases_root());
  }
  if (app.got_subcommand("list")) {
    if (comm.rank() == 0) list_options(arguments.what, cases_root());
    return 0;
  }
  if (app.got_subcommand("render")) return comm.rank() == 0 ? render_run(arguments.directory, arguments.field) : 0;
  CaseDescription description;
  agree(comm, [&] { description = read_case(arguments.case_name, arguments.overrides, cases_root()); });
  if (app.got_subcommand("run")) return run_case(description, arguments.run, comm);
  check_case_runs(description, comm);
  if (comm.rank() == 0) std::printf("%s: the case is valid\n", description.name.c_str());
  return 0;
}

/// For what every rank meets alike: says it once.
int report(const std::string& message, int status) {
  if (Communicator().rank() == 0) std::fprintf(stderr, "mortise: %s\n", message.c_str());
  return status;
}

/// For what this rank alone may have met: ends the ranks that wait for it.
int report_alone(const std::string& message, int status) {
  const Communicator comm;
  std::fprintf(stderr, "mortise: %s\n", message.c_str());
  if (comm.size() > 1) MPI_Abort(comm.raw(), status);
  return status;
}

/// What was printed has arrived.
void flush_output() {
  if (std::fflush(stdout) != 0) throw EnvironmentError("cannot write to the standard output: " + std::string(std::strerror(errno)));
}

}  // namespace

int program(int argc, const char* const* argv) {
  CLI::App app("mortise: fluid-structure interaction in high-speed flow", "mortise");
  app.require_subcommand(1);
  app.set_version_flag("--version", provenance().version + " (" + provenance().git + ")", "Print the version and exit");
  app.footer(exit_statuses);
  Arguments arguments;
  add_run(app, arguments);
  add_case_command(app, "check", "read and validate a case, run nothing", arguments);
  app.add_subcommand("list", "list what there is to choose from")
      ->add_option("what", arguments.what, "cases, schemes, riemann, limiters, shapes, boundaries, initial, exact, pictures, keys");
  add_study(app, arguments.study);
  CLI::App* render = app.add_subcommand("render", "make pictures from a finished run");
  render->add_option("directory", arguments.directory, "output directory of the run")->required();
  render->add_option("--field", arguments.field, "schlieren, pressure, velocity, mach, density, stress, grids")->default_val("schlieren");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return Communicator().rank() == 0 ? app.exit(error) : 0;  // --help
    return report(explain(app, error), 2);
  }
  try {
    const int status = dispatch(app, arguments);
    flush_output();
    return status;
  } catch (const AgreedFailure& failure) {
    return report(failure.what(), failure.status);
  } catch (const NumericalError& error) {
    return report(error.what(), 3);
  } catch (const InputError& error) {
    return report_alone(error.what(), 2);
  } catch (const EnvironmentError& error) {
    return report_alone(error.what(), 4);
  } catch (const std::filesystem::filesystem_error& error) {
    return report_alone(error.what(), 4);
  } catch (const std::bad_alloc&) {
    return report_alone("out of memory", 4);
  }
}

}  // namespace mortise
