// A user's mistake: exit status 2, one sentence with place and remedy, nothing written.
#include <cmath>

#include "verification/program_run.hpp"

namespace mortise::testing {
namespace {

struct Mistake {
  std::string name;
  Arguments arguments;                 // added to those of a valid run
  std::vector<std::string> fragments;  // of the sentence, in this order
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

Arguments sets(const Arguments& values) {
  Arguments all;
  for (const std::string& value : values) all.insert(all.end(), {"--set", value});
  return all;
}

/// An elastic disk between the two bodies, as written but for some of its keys.
Arguments soft_disk(const std::string& keys, const std::string& material = "density=1, lambda=1, mu=1") {
  return sets({"solids=[{shape=\"circle\", " + keys + ", material={" + material + "}}]"});
}

/// The same disk as the only body, in a liquid.
Arguments in_liquid(const std::string& keys, const Arguments& more) {
  Arguments all = soft_disk(keys);
  for (const Arguments& part : {sets({"bodies=[]", "scheme=reference-map", "fluid.kind=incompressible"}), sets(more)})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Arguments spline(const std::string& file) { return sets({"bodies.0.shape=spline", "bodies.0.points=" + file}); }

/// A folder with the valid case and outlines that are none.
class BadInput : public ::testing::TestWithParam<Mistake> {
 protected:
  BadInput() {
    write("case.toml", two_bodies);
    write("words.txt", "0 0\n0.2 0\nabc 1\n");
    write("cross.txt", "0 0\n0.2 0.2\n0.2 0\n0 0.2\n0 0\n");
    std::string half_circle;
    for (int k = 0; k <= 12; ++k)
      half_circle += std::to_string(0.2 * std::cos(k * 0.25)) + " " + std::to_string(0.2 * std::sin(k * 0.25)) + "\n";
    write("open.txt", half_circle);
    write("broken.toml", "[grid]\nfactor = = 4\n");
  }
  void write(const std::string& name, const std::string& text) const { write_file(folder / name, text); }

  Outcome start(const Arguments& arguments, int ranks = 0) const {
    return run_program(arguments, {ranks, folder.path()});
  }

  /// Status 2, one line on stderr with the fragments, nothing else, no output.
  void expect_refused(const Outcome& outcome, const std::vector<std::string>& fragments) const {
    EXPECT_EQ(outcome.status, 2) << outcome.errors;
    EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("mortise: ", 0), 0U) << outcome.errors;
    std::size_t at = 0;
    for (const std::string& fragment : fragments) {
      at = outcome.errors.find(fragment, at);
      ASSERT_NE(at, std::string::npos) << '"' << fragment << "\" in: " << outcome.errors;
    }
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(files_in(folder.path()).size(), 5U);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }

  const ScratchFolder folder;
};

TEST_P(BadInput, RunAndCheckRefuse) {
  const Arguments wrong = GetParam().arguments;
  expect_refused(start(Arguments{"run", "case.toml", "--output", "out"} + wrong), GetParam().fragments);
  expect_refused(start(Arguments{"check", "case.toml"} + wrong), GetParam().fragments);
}

std::vector<Mistake> mistakes() {
  return {
      {"misspelt_key", sets({"time.clf=0.5"}), {"--set time.clf=0.5", "unknown key \"clf\"", "did you mean \"cfl\"?"}},
      {"key_in_a_table", sets({"initial.gravity=[0, -1]"}), {"\"gravity\" in initial, which belongs before"}},
      {"misspelt_table", sets({"tiem.end=1"}), {"unknown key \"tiem\"", "did you mean \"time\"?"}},
      {"unknown_key", sets({"qqqqqqqqqqqq=3"}), {"unknown key \"qqqqqqqqqqqq\"", "(known: title"}},
      {"no_such_body", sets({"bodies.2.density=1"}), {"there is no entry 2 in bodies"}},
      {"not_an_assignment", sets({"time.end"}), {"--set time.end", "expected key=value"}},
      {"wrong_type", sets({"time.cfl=fast"}), {"time.cfl must be a number in (0, 1], not \"fast\""}},
      {"missing_key", sets({"bodies.0={shape=\"circle\"}"}), {"the key \"bodies.0.radius\" is missing"}},
      {"negative_density", sets({"bodies.0.density=-1"}), {"bodies.0.density = -1", "must be ≥ 0"}},
      {"gas_without_density", sets({"initial.state=[0, 0, 0, 1]"}), {"(density) = 0", "must be > 0"}},
      {"negative_pressure", sets({"initial.state=[1, 0, 0, -1]"}), {"(pressure) = -1", "must be > 0"}},
      {"negative_pressure_somewhere",
       sets({"initial={kind=\"regions\", regions=[{density=1, velocity=[0, 0], pressure=\"0.9 - x\"}]}"}),
       {"case.toml", "initial", "pressure -0.0", "at (0.9", "pressure > 0"}},
      {"cfl_above_1", sets({"time.cfl=1.01"}), {"time.cfl = 1.01", "(0, 1]"}},
      {"cfl_0", sets({"time.cfl=0"}), {"time.cfl = 0", "(0, 1]"}},
      {"gamma_1", sets({"gas.gamma=1"}), {"gas.gamma = 1", "> 1"}},
      {"crossing_polygon",
       sets({"bodies.1.corners=[[-0.2, -0.2], [0.2, 0.2], [0.2, -0.2], [-0.2, 0.2]]"}),
       {"case.toml:19:", "bodies.1 (second)", "the polygon crosses or touches itself"}},
      {"fillet_too_large", sets({"bodies.1.fillet=0.5"}), {"case.toml:19:", "a fillet of 0.5 does not fit"}},
      {"crossing_spline", spline("cross.txt"), {"case.toml:13:", "cross.txt", "crosses or touches itself"}},
      {"open_spline", spline("open.txt"), {"open.txt", "the outline is open"}},
      {"spline_of_words", spline("words.txt"), {"words.txt:3", "expected two numbers", "abc 1"}},
      {"no_spline_file", spline("none.txt"), {"none.txt", "cannot be read"}},
      {"spline_file_is_a_folder", spline("."), {"bodies.0.points", "cannot be read"}},
      {"overlapping_bodies",
       sets({"bodies.1.position=[-0.2, 0]"}),
       {"case.toml:13:", "bodies.0 (first) overlaps bodies.1 (second)", "move it by at least"}},
      {"bodies_too_close",
       sets({"bodies.1.position=[0.0, 0.05]"}),
       {"bodies.0 (first) is too close to bodies.1 (second)", "the gap is", "set grid.factor to at least"}},
      {"centre_outside", sets({"bodies.1.position=[3, 0]"}), {"bodies.1.position is outside the domain"}},
      {"reaching_outside", sets({"bodies.1.position=[0.9, 0]"}), {"case.toml:19:", "reaches outside the domain"}},
      {"close_to_the_edge", sets({"bodies.0.position=[-0.77, 0]"}), {"is too close to the edge of the domain"}},
      {"massless_and_traditional",
       sets({"scheme=traditional", "bodies.0.density=0"}),
       {"scheme = \"traditional\" cannot move bodies.0", "density is 0", "use rigid"}},
      {"unknown_scheme", sets({"scheme=tradtional"}), {"did you mean \"traditional\"?", "(allowed: none, rigid"}},
      {"bodies_without_scheme", sets({"scheme=none"}), {"scheme = \"none\" cannot move bodies"}},
      {"unknown_limiter", sets({"fluid.limiter=mcc"}), {"did you mean \"mc\"?"}},
      {"motion_not_0_at_the_start", sets({"bodies.0.motion.x=1+t"}), {"must be 0 at t = 0"}},
      {"formula_that_is_none", sets({"bodies.0.force.x=sin(t"}), {"bodies.0.force.x"}},
      {"names_twice", sets({"bodies.0.name=second"}), {"\"second\" is the name of another one"}},
      {"shear_modulus_0",
       soft_disk("radius=0.1, position=[0, 0.6]", "density=1, lambda=1, mu=0"),
       {"solids.0.material.mu = 0", "must be > 0"}},
      {"unstable_material",
       soft_disk("radius=0.1, position=[0, 0.6]", "density=1, lambda=-2, mu=1"),
       {"solids.0.material.lambda = -2", "λ + μ must be > 0"}},
      {"unknown_law",
       soft_disk("radius=0.1, position=[0, 0.6]", "law=\"liner\", density=1, lambda=1, mu=1"),
       {"did you mean \"linear\"?"}},
      {"interface_without_a_scheme",
       with(soft_disk("radius=0.1, position=[0, 0.6]"), sets({"scheme=rigid"})),
       {"leaves the interface of solids.0 (circle_2) without a scheme", "use projection"}},
      {"reference_map_beside_bodies",
       with(soft_disk("radius=0.1, position=[0, 0.6]"), sets({"scheme=reference-map"})),
       {"reference-map", "moves elastic solids only"}},
      {"reference_map_of_a_thin_solid",
       with(soft_disk("radius=0.05, position=[0, 0.6]"), sets({"scheme=reference-map", "bodies=[]", "coupling.blur=3"})),
       {"solids.0", "the blur zone, 3", "wider than the solid", "grid.factor"}},
      {"reference_map_and_another_riemann_solver",
       with(soft_disk("radius=0.2, position=[0, 0.6]"), sets({"scheme=reference-map", "bodies=[]", "fluid.riemann=exact"})),
       {"needs fluid.riemann = \"hllc\""}},
      {"reference_map_of_linear_elasticity",
       with(soft_disk("radius=0.2, position=[0, 0.6]", "law=\"linear\", density=1, lambda=1, mu=1"), sets({"scheme=reference-map", "bodies=[]"})),
       {"law for finite strains, neo_hookean"}},
      {"shock_in_an_incompressible_fluid",
       sets({"fluid.kind=incompressible", "bodies=[]", "initial={kind=\"shock\", ahead=[1, 0, 0, 1], mach=2}"}),
       {"fluid.kind = \"incompressible\" has no shock", "uniform or regions"}},
      {"unknown_actuation",
       with(soft_disk("radius=0.2, position=[0, 0.6], actuation=\"sin(q)\""), sets({"scheme=reference-map", "bodies=[]", "fluid.kind=incompressible"})),
       {"solids.0.actuation", "q"}},
      {"anchors_in_gas",
       with(soft_disk("radius=0.2, position=[0, 0.6], anchors=[{radius=0.1}]"), sets({"scheme=reference-map", "bodies=[]"})),
       {"solids.0.anchors needs fluid.kind"}},
      {"incompressible_fluid_under_another_scheme",
       with(soft_disk("radius=0.2, position=[0, 0.6]"), sets({"bodies=[]", "fluid.kind=incompressible"})),
       {"needs scheme = \"reference-map\""}},
      {"oscillation_in_gas", sets({"output.oscillation=[0, 0.1]"}), {"output.oscillation needs scheme = \"reference-map\""}},
      {"oscillation_without_probes",
       in_liquid("radius=0.2, position=[0, 0]", {"output.oscillation=[0, 0.1]"}),
       {"output.oscillation needs", "at least one of probes"}},
      {"oscillation_from_late_to_early",
       in_liquid("radius=0.2, position=[0, 0]", {"probes=[{position=[0, 0]}]", "output.oscillation=[0.05, 0.05]"}),
       {"output.oscillation = [0.05, 0.05] is not allowed", "from < to ≤ time.end = 0.1"}},
      {"oscillation_after_the_end",
       in_liquid("radius=0.2, position=[0, 0]", {"probes=[{position=[0, 0]}]", "output.oscillation=[0.05, 0.2]"}),
       {"output.oscillation = [0.05, 0.2] is not allowed"}},
      {"contours_without_a_reference_map", sets({"output.contours=true"}), {"it needs scheme = \"reference-map\""}},
      {"solid_outside_of_a_liquid",
       in_liquid("radius=0.2, position=[0, 2]", {}),
       {"solids.0.position is outside the domain"}},
      {"solid_reaching_out_of_a_liquid",
       in_liquid("radius=0.25, position=[0.8, 0]", {}),
       {"circle_0 reaches 0.05", "beyond the right side of the domain"}},
      {"displaced_solid_reaching_out_of_a_liquid",
       in_liquid("radius=0.25, position=[0, 0.7], initial={kind=\"formula\", displacement=[0, 0.1]}", {}),
       {"circle_0 reaches 0.05", "beyond the top side of the domain"}},
      {"solid_on_body", soft_disk("radius=0.2, position=[0.1, 0]"), {"overlaps solids.0 (circle_2)", "at t = 0"}},
      {"inverted_solid",
       soft_disk("radius=0.2, position=[0, 0.6], initial={kind=\"formula\", displacement=[\"-2*x\", 0]}"),
       {"solids.0 (circle_2)", "J = det(I + ∇u) is -1", "must be > 0"}},
  };
}

INSTANTIATE_TEST_SUITE_P(Case, BadInput, ::testing::ValuesIn(mistakes()),
                         [](const ::testing::TestParamInfo<Mistake>& mistake) { return mistake.param.name; });

using BadFile = BadInput;

TEST_F(BadFile, Refused) {
  expect_refused(start({"run", "broken.toml", "--output", "out"}), {"broken.toml:2:10: "});
  expect_refused(start({"run", "missing.toml", "--output", "out"}), {"there is no case file \"missing.toml\""});
  expect_refused(start({"run", "sodd", "--output", "out"}), {"no case \"sodd\"", "did you mean \"sod\"?"});
}

TEST_F(BadFile, CommandLine) {
  expect_refused(start({}), {"a command is missing: run, check, list"});
  expect_refused(start({"chek", "case.toml"}), {"unknown command \"chek\"", "did you mean \"check\"?"});
  expect_refused(start({"run", "case.toml", "--untl", "1"}),
                 {"unknown option \"--untl\"", "did you mean \"--until\"?"});
  expect_refused(start({"run", "case.toml", "more"}), {"unexpected argument \"more\""});
  expect_refused(start({"run"}), {"case is required"});
  for (const char* time : {"0", "-1", "nan", "inf", "soon"})
    expect_refused(start({"run", "case.toml", "--until", time}), {"--until", "must be a number > 0, not", time});
  for (const char* number : {"-1", "1.5", "many", "100001"})
    expect_refused(start({"run", "case.toml", "--frames", number}), {"--frames", "must be an integer", number});
  expect_refused(start({"list", "shemes"}), {"unknown list \"shemes\"", "did you mean \"schemes\"?"});
  expect_refused(start({"render", "nowhere"}), {"\"nowhere\" holds no fields"});
}

TEST_F(BadFile, OutputDirectory) {
  expect_refused(start({"run", "case.toml", "--output", "case.toml"}), {"\"case.toml\" is a file"});
  expect_refused(start({"run", "case.toml", "--output", "case.toml/out"}), {"case.toml/out", "is not a directory"});
  expect_refused(start({"run", "case.toml", "--output", "/proc/nothing/out"}), {"/proc/nothing/out", "cannot be"});
}

TEST_F(BadFile, ElasticScenes) {
  const auto refused = [&](const std::string& name, const Arguments& values,
                           const std::vector<std::string>& fragments) {
    expect_refused(start(Arguments{"run", name, "--output", "out"} + sets(values)), fragments);
  };
  const std::string strip = "{shape=\"strip\", thickness=1, material={density=1, lambda=1, mu=1}}";
  refused("elastic_piston", {"exact=none", "boundaries.right=outflow", "solids=[" + strip + ", " + strip + "]"},
          {"solids.1 (strip_1) and solids.0 (strip_0) would share one interface", "belongs to one solid"});
  refused("radial_shell", {"grid.high=[0.4, 0.6]"}, {"solids.0 (shell)", "boundaries of gas and solid must coincide"});
  refused("deforming_diffuser",
          {"solids.0.wall=-0.9*(1-cos(2*pi*x))", "exact=none", "initial.kind=uniform", "boundaries.left=inflow",
           "boundaries.right=outflow", "boundaries.top=outflow"},
          {"solids.0 (strip)", "folded at t = 0: cell (", "at ("});
  refused("deforming_diffuser", {"solids.0.wall=-0.9*(1-cos(2*pi*x))"}, {"deforming_diffuser", "Prandtl-Meyer angle"});
  const std::string fold = "initial={kind=\"formula\", displacement=[\"6*x*(1-x^2-y^2)\", \"6*y*(1-x^2-y^2)\"]}";
  refused("radial_shell", {"exact=none", "solids.0." + fold}, {"solids.0 (shell)", "J = det(I + ∇u) is -0.", "> 0"});
}

TEST_F(BadFile, EarlierRunIsKeptUnlessOverwritten) {
  const Arguments run = {"run", "case.toml", "--output", "out", "--quiet"};
  ASSERT_EQ(start(run).status, 0);
  const std::string before = read_file(folder / "out/summary.json");
  const Outcome again = start(run + Arguments{"--set", "time.end=0.05"});
  EXPECT_EQ(again.status, 2);
  EXPECT_EQ(lines(again.errors).size(), 1U) << again.errors;
  EXPECT_NE(again.errors.find("\"out\" holds a run already"), std::string::npos) << again.errors;
  EXPECT_NE(again.errors.find("--overwrite"), std::string::npos) << again.errors;
  EXPECT_EQ(read_file(folder / "out/summary.json"), before);
  write_file(folder / "out/notes.txt", "the user's own");
  ASSERT_EQ(start(run + Arguments{"--set", "output.frames=0", "--overwrite"}).status, 0);
  EXPECT_EQ(files_in(folder / "out"), (std::set<std::string>{"bodies.csv", "notes.txt", "summary.json"}));
}

/// Exit status of each of two ranks, and what they wrote to stderr together.
std::pair<std::vector<std::string>, std::string> on_two_ranks(const std::string& folder, const Arguments& arguments) {
  // The shell only notes the exit status of a rank.
  const std::string note = "\"$0\" \"$@\"; echo $? > status.$OMPI_COMM_WORLD_RANK";
  Program program({"mpiexec", "--oversubscribe", "-n", "2", "sh", "-c", note, MORTISE_PROGRAM}, arguments,
                  {.folder = folder});
  const Outcome outcome = program.wait();
  std::vector<std::string> statuses;
  for (const char* rank : {"0", "1"}) {
    const std::string path = folder + "/status." + rank;
    statuses.push_back(std::filesystem::exists(path) ? lines(read_file(path)).at(0) : "never ended");
    std::filesystem::remove(path);
  }
  return {statuses, outcome.errors};
}

TEST_F(BadFile, TwoRanksSayItOnceAndBothEnd) {
  std::filesystem::create_directory(folder / "taken");
  write_file(folder / "taken/summary.json", "{}");
  const std::vector<Mistake> all = mistakes();
  const Mistake& somewhere = *std::ranges::find(all, "negative_pressure_somewhere", &Mistake::name);
  const std::vector<std::pair<Arguments, std::string>> wrong = {
      {{"run", "case.toml", "--untl", "1"}, "unknown option"},
      {Arguments{"run", "case.toml"} + sets({"time.clf=0.5"}), "unknown key"},
      {Arguments{"check", "case.toml"} + sets({"bodies.1.position=[-0.2, 0]"}), "overlaps"},
      {Arguments{"run", "case.toml"} + somewhere.arguments, "pressure > 0"},
      {{"run", "case.toml", "--output", "taken"}, "holds a run already"}};
  for (const auto& [arguments, fragment] : wrong) {
    const auto [statuses, errors] = on_two_ranks(folder.path(), arguments);
    EXPECT_EQ(statuses, (std::vector<std::string>{"2", "2"})) << fragment;
    EXPECT_EQ(lines(errors).size(), 1U) << errors;
    EXPECT_NE(errors.find(fragment), std::string::npos) << errors;
  }
}

}  // namespace
}  // namespace mortise::testing
