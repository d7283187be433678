#include "mortise/cases/study/command.hpp"

#include <memory>

#include "mortise/cases/driver/command_line_errors.hpp"
#include "mortise/cases/study/convergence.hpp"
#include "mortise/cases/study/cost.hpp"
#include "mortise/cases/study/growth_member.hpp"
#include "mortise/cases/study/published.hpp"
#include "mortise/cases/study/stability.hpp"
#include "mortise/cases/study/stress.hpp"

namespace mortise {
namespace {

using Run = std::function<int(const std::string& cases_root)>;

/// What all kinds take.
void add_common(CLI::App& command, StudyOptions& options) {
  command.add_option("--set", options.overrides, "key=value: replace a value of the case file, for all members")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  command
      .add_option("--output", options.output,
                  "directory to write to, and to resume from; default: output/<study>_<case>")
      ->type_name("DIR");
  command.add_option("--jobs", options.jobs, "runs at a time; default: one a core")
      ->type_name("N")
      ->check(count_from(1, 4096));
  command.add_flag("--quiet", options.quiet, "no progress");
}

template <class Options>
std::shared_ptr<Options> add_kind(CLI::App& study, const char* name, const char* meaning, Run& run,
                                  int (*action)(Options), bool with_case = true) {
  CLI::App* command = study.add_subcommand(name, meaning);
  auto options = std::make_shared<Options>();
  if (with_case)
    command->add_option("case", options->case_name, "name of a shipped case, or path of a TOML file")->required();
  add_common(*command, *options);
  command->callback([options, &run, action] {
    run = [options, action](const std::string& cases_root) {
      options->cases_root = cases_root;
      return action(*options);
    };
  });
  return options;
}

void add_convergence(CLI::App& study, Run& run) {
  const auto options = add_kind<ConvergenceOptions>(
      study, "convergence", "errors and orders over a sequence of resolutions", run, study_convergence);
  CLI::App* command = study.get_subcommand("convergence");
  command->add_option("--vary", options->vary, "key, doubled from the case's value on; or key=v1,v2,…")
      ->capture_default_str();
  command->add_option("--levels", options->levels, "how many resolutions")
      ->capture_default_str()
      ->check(count_from(2, 12));
  command->add_option("--against", options->against, "exact (default where there is an exact solution), self")
      ->check(CLI::IsMember({"exact", "self"}));
}

void add_cost(CLI::App& study, Run& run) {
  const auto options = add_kind<CostOptions>(study, "cost", "run time against error for every scheme", run, study_cost);
  CLI::App* command = study.get_subcommand("cost");
  command->add_option("--vary", options->vary, "key, doubled from the case's value on; or key=v1,v2,…")
      ->capture_default_str();
  command->add_option("--levels", options->levels, "how many resolutions")
      ->capture_default_str()
      ->check(count_from(1, 12));
  command->add_option(
      "--schemes", options->schemes,
      "a,b,c, with variants as projection+substeps, traditional+lagged; default: all that can run the scene");
  command->add_option("--limiters", options->limiters, "a,b,c of the gas; default: the case's");
  command->add_option("--cfls", options->cfls, "a,b,c; default: the case's");
  command->add_option("--repeats", options->repeats, "runs of each, interleaved; the median counts")
      ->capture_default_str()
      ->check(count_from(1, 99));
  command->add_option("--against", options->against, "exact (default where there is an exact solution), self")
      ->check(CLI::IsMember({"exact", "self"}));
  command->add_option("--quantity", options->quantity,
                      "whose L1 error counts; default: the geometric mean of all, relative to the first run's");
}

void add_stability(CLI::App& study, Run& run) {
  const auto options = add_kind<StabilityOptions>(
      study, "stability", "which schemes hold a scene, measured and by theory", run, study_stability);
  CLI::App* command = study.get_subcommand("stability");
  command->add_option("--vary", options->vary, "key=v1,v2,…, for example solid.scale=0.1,1,10")->required();
  command->add_option("--schemes", options->schemes,
                      "a,b,c, with variants as traditional+lagged; default: all that can run the scene");
  command->add_option("--steps", options->steps, "that a disturbance is followed for")
      ->capture_default_str()
      ->check(count_from(10, 1000000));
  command->add_flag("--along-wall", options->along_wall, "disturb strips along the wall, too: what happens in the plane");
  command->add_flag("--threshold", options->threshold,
                    "find by bisection where growth begins, between the least and the largest value");
  const auto member = add_kind<GrowthMemberOptions>(
      study, "growth", "growth of small disturbances of a case, measured and by theory, as JSON in the file --output",
      run, write_growth);
  study.get_subcommand("growth")
      ->add_option("--steps", member->steps, "that a disturbance is followed for")
      ->capture_default_str()
      ->check(count_from(10, 1000000));
  study.get_subcommand("growth")->add_flag("--along-wall", member->along_wall, "disturb strips along the wall, too");
}

void add_stress(CLI::App& study, Run& run) {
  const auto options = add_kind<StressOptions>(study, "stress", "random scenes, to find failures of the program", run,
                                               study_stress, false);
  CLI::App* command = study.get_subcommand("stress");
  command->add_option("--minutes", options->minutes, "how long")->capture_default_str()->check(positive_number());
  command->add_option("--seed", options->seed, "of the first scene")->capture_default_str();
  command->add_option("--scenes", options->scenes, "at most; default: as many as there is time for");
  command->add_option("--time-limit", options->time_limit, "seconds after which a run counts as hanging")
      ->capture_default_str()
      ->check(positive_number());
}

void add_published(CLI::App& study, Run& run) {
  const auto options =
      add_kind<PublishedOptions>(study, "published", "published numbers beside ours", run, study_published, false);
  study.get_subcommand("published")
      ->add_option("--only", options->only,
                   "a,b of elastic_piston, superseismic_shock, cylinder_in_solid, rigid_piston, massless_ellipse, "
                   "solid_modes; default: all");
}

}  // namespace

void add_study(CLI::App& app, Run& run) {
  CLI::App* study = app.add_subcommand("study", "studies: many runs, a table and a picture");
  study->require_subcommand(1);
  add_convergence(*study, run);
  add_cost(*study, run);
  add_stability(*study, run);
  add_published(*study, run);
  add_stress(*study, run);
}

}  // namespace mortise
