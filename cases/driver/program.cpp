#include "mortise/cases/driver/program.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "mortise/cases/driver/list.hpp"
#include "mortise/cases/driver/render_run.hpp"
#include "mortise/cases/driver/run_case.hpp"
#include "mortise/cases/input/case_file.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

struct Arguments {
  std::string case_name, directory, what;
  std::vector<std::string> overrides;
  std::string field;
  RunOptions run;
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
      ->take_all()
      ->allow_extra_args(false);
  return command;
}

void add_run(CLI::App& app, Arguments& arguments) {
  CLI::App* run = add_case_command(app, "run", "run a case", arguments);
  run->add_option("--output", arguments.run.output, "directory to write to");
  run->add_option("--until", arguments.run.until, "end at this time")->check(CLI::PositiveNumber);
  run->add_option("--frames", arguments.run.frames, "pictures over the run, besides t = 0")->check(CLI::NonNegativeNumber);
  run->add_option("--restart", arguments.run.restart, "continue the run in this directory from its last checkpoint");
  run->add_flag("--no-skip", arguments.run.no_skip, "compute everything, also what cannot change");
  run->add_flag("--quiet", arguments.run.quiet, "print nothing but errors");
  run->add_flag("--overwrite", arguments.run.overwrite, "replace the run in the output directory");
}

int dispatch(CLI::App& app, const Arguments& arguments) {
  const Communicator comm;
  if (app.got_subcommand("list")) {
    if (comm.rank() == 0) list_options(arguments.what, cases_root());
    return 0;
  }
  if (app.got_subcommand("render")) return comm.rank() == 0 ? render_run(arguments.directory, arguments.field) : 0;
  const CaseDescription description = read_case(arguments.case_name, arguments.overrides, cases_root());
  if (app.got_subcommand("run")) return run_case(description, arguments.run, comm);
  check_case_runs(description, comm);
  if (comm.rank() == 0) std::printf("%s: the case is valid\n", description.name.c_str());
  return 0;
}

/// Says what is wrong, once; ranks that may be waiting for this one are ended with it.
int report(const std::string& message, int status) {
  const Communicator comm;
  // An input error is seen by every rank alike, but other failures may not be.
  if (comm.rank() == 0 || status != 2) std::fprintf(stderr, "mortise: %s\n", message.c_str());
  if (comm.size() > 1 && status != 2) MPI_Abort(comm.raw(), status);
  return status;
}

}  // namespace

int program(int argc, const char* const* argv) {
  CLI::App app("mortise: fluid-structure interaction in high-speed flow");
  app.require_subcommand(1);
  Arguments arguments;
  add_run(app, arguments);
  add_case_command(app, "check", "read and validate a case, run nothing", arguments);
  app.add_subcommand("list", "list what there is to choose from")
      ->add_option("what", arguments.what, "cases, schemes, riemann, limiters, shapes, boundaries, initial, exact, pictures, keys");
  CLI::App* render = app.add_subcommand("render", "make pictures from a finished run");
  render->add_option("directory", arguments.directory, "output directory of the run")->required();
  render->add_option("--field", arguments.field, "schlieren, pressure, velocity, mach, density, grids")->default_val("schlieren");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    return report(std::string(error.what()) + " (see mortise --help)", 2);
  }
  try {
    return dispatch(app, arguments);
  } catch (const InputError& error) {
    return report(error.what(), 2);
  } catch (const NumericalError& error) {
    return report(error.what(), 3);
  } catch (const EnvironmentError& error) {
    return report(error.what(), 4);
  } catch (const std::bad_alloc&) {
    return report("out of memory", 4);
  }
}

}  // namespace mortise
