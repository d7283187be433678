// Types and ranges of single keys, by the sentence they give.
#include "mortise/cases/input/section.hpp"

#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using test::error_of, test::line_case, test::plane_case, test::with;

TEST(Range, Text) {
  EXPECT_EQ((Range{.low = 0, .high = 1, .low_open = true}).text(), " in (0, 1]");
  EXPECT_EQ(positive.text(), " > 0");
  EXPECT_EQ(non_negative.text(), " ≥ 0");
  EXPECT_EQ(any_number.text(), "");
  EXPECT_FALSE(positive.contains(0));
  EXPECT_TRUE(non_negative.contains(0));
}

TEST(Section, TheSampleIsValid) {
  EXPECT_EQ(error_of(plane_case), "");
  EXPECT_EQ(error_of(line_case), "");
}

TEST(Section, Ranges) {
  EXPECT_EQ(error_of(with(plane_case, "cfl = 0.8", "cfl = 1.5")),
            "scratch.toml:8:7: time.cfl = 1.5 is not allowed: it must be in (0, 1]");
  EXPECT_EQ(error_of(with(plane_case, "cfl = 0.8", "cfl = 0")),
            "scratch.toml:8:7: time.cfl = 0 is not allowed: it must be in (0, 1]");
  EXPECT_EQ(error_of(plane_case, {"gas.gamma=1"}), "--set gas.gamma=1: gas.gamma = 1 is not allowed: it must be > 1");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.density=-1"}),
            "--set bodies.0.density=-1: bodies.0.density = -1 is not allowed: it must be ≥ 0");
  EXPECT_EQ(error_of(plane_case, {"time.end=inf"}), "--set time.end=inf: time.end = inf is not a finite number");
  EXPECT_EQ(error_of(plane_case, {"time.end=nan"}), "--set time.end=nan: time.end = nan is not a finite number");
  EXPECT_EQ(error_of(plane_case, {"dimension=3"}),
            "--set dimension=3: dimension = 3 is not allowed: it must be in [1, 2]");
}

TEST(Section, Types) {
  EXPECT_EQ(error_of(with(plane_case, "end = 0.5", "end = \"soon\"")),
            "scratch.toml:7:7: time.end must be a number > 0, not \"soon\"");
  EXPECT_EQ(error_of(with(plane_case, "title = \"a cylinder\"", "title = 7")),
            "scratch.toml:1:9: title must be a string, not 7");
  EXPECT_EQ(error_of(plane_case, {"output.frames=2.5"}),
            "--set output.frames=2.5: output.frames must be an integer in [0, 100000], not 2.5");
  EXPECT_EQ(error_of(plane_case, {"output.hdf5=1"}), "--set output.hdf5=1: output.hdf5 must be true or false, not 1");
  EXPECT_EQ(error_of(plane_case, {"time=3"}), "--set time=3: time must be a table, not 3");
  EXPECT_EQ(error_of(plane_case, {"probes=3"}), "--set probes=3: probes must be an array of tables, [[probes]], not 3");
  EXPECT_EQ(error_of(plane_case, {"probes=[3]"}), "--set probes=[3]: probes.0 must be a table, not 3");
  EXPECT_EQ(error_of(plane_case, {"output.pictures=mach"}),
            "--set output.pictures=mach: output.pictures must be a list of any of schlieren, pressure, velocity, mach, vorticity, stress, "
            "grids, "
            "not \"mach\"");
}

TEST(Section, VectorsHaveTheDimensionOfTheCase) {
  EXPECT_EQ(error_of(with(plane_case, "low = [-1, -1]", "low = [-1, -1, -1]")),
            "scratch.toml:4:7: grid.low must be an array of 2 numbers in 2D, not an array of 3");
  EXPECT_EQ(error_of(with(plane_case, "low = [-1, -1]", "low = -1")),
            "scratch.toml:4:7: grid.low must be an array of 2 numbers in 2D, not -1");
  EXPECT_EQ(error_of(with(plane_case, "low = [-1, -1]", "low = [-1, \"a\"]")),
            "scratch.toml:4:12: grid.low.1 must be a number, not \"a\"");
  EXPECT_EQ(error_of(with(line_case, "low = -1", "low = [-1]")), "");
  EXPECT_EQ(error_of(with(line_case, "low = -1", "low = [-1, -1]")),
            "scratch.toml:4:7: grid.low must be a single value in 1D, not an array of 2");
}

TEST(Section, States) {
  EXPECT_EQ(error_of(with(plane_case, "[1, 0, 0, 1]", "[-1, 0, 0, 1]")),
            "scratch.toml:11:10: initial.state.0 (density) = -1 is not allowed: it must be > 0");
  EXPECT_EQ(error_of(with(plane_case, "[1, 0, 0, 1]", "[1, 0, 0, -2]")),
            "scratch.toml:11:19: initial.state.3 (pressure) = -2 is not allowed: it must be > 0");
  EXPECT_EQ(error_of(with(plane_case, "[1, 0, 0, 1]", "[1, 0, 0, -2]"), {"gas.p_inf=3"}), "");
  EXPECT_EQ(error_of(with(plane_case, "[1, 0, 0, 1]", "[1, 0, 1]")),
            "scratch.toml:11:9: initial.state must be an array [ρ, u, v, p] of 4 numbers in 2D, not an array of 3");
  const CaseDescription line = test::read_text(with(line_case, "[1, 0, 1]", "[2, 3, 4]"));
  EXPECT_EQ(line.initial.state, (std::array<double, 4>{2, 3, 0, 4}));
}

TEST(Section, Choices) {
  EXPECT_EQ(
      error_of(plane_case, {"fluid.limiter=minmood"}),
      "--set fluid.limiter=minmood: fluid.limiter = \"minmood\" is not known, did you mean \"minmod\"? (allowed: none, "
      "minmod, mc, van_albada)");
  EXPECT_EQ(error_of(plane_case, {"output.pictures=[\"mach\", \"presure\"]"})
                .find("output.pictures.1 = \"presure\" is not known"),
            std::string("--set output.pictures=[\"mach\", \"presure\"]: ").size());
}

TEST(Section, Formulas) {
  EXPECT_EQ(error_of(plane_case, {"bodies.0.force.x=sin(t)"}), "");
  EXPECT_EQ(test::read_text(plane_case, {"bodies.0.force.x=0.1"}).bodies[0].force_x, "0.1");
  const std::string error = error_of(plane_case, {"bodies.0.force.x=sin(x)"});
  EXPECT_EQ(
      error.rfind(
          "--set bodies.0.force.x=sin(x): bodies.0.force.x: in the formula \"sin(x)\" the name \"x\" at character 5",
          0),
      0u)
      << error;
  EXPECT_EQ(error_of(plane_case, {"bodies.0.force.x=true"}),
            "--set bodies.0.force.x=true: bodies.0.force.x must be a formula of t or a number, not true");
}

TEST(Section, MissingKeys) {
  EXPECT_EQ(error_of(with(plane_case, "end = 0.5\n", "")),
            "scratch.toml:6:1: the key \"time.end\" is missing: a number > 0, the time at which the run ends");
  EXPECT_EQ(error_of(with(plane_case, "shape = \"circle\"\n", ""))
                .rfind("scratch.toml:13:1: the key \"bodies.0.shape\" is missing", 0),
            0u);
  EXPECT_EQ(error_of("").rfind("scratch.toml: the key \"grid.factor\" is missing", 0), 0u) << error_of("");
}

}  // namespace
}  // namespace mortise
