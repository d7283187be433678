#include "mortise/cases/input/unknown_keys.hpp"

#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using test::error_of, test::plane_case, test::with;

TEST(UnknownKeys, NearestInTheSameTable) {
  EXPECT_EQ(error_of(with(plane_case, "cfl = 0.8", "clf = 0.8")),
            "scratch.toml:8:1: unknown key \"clf\" in time, did you mean \"cfl\"? (known: end, cfl, step)");
  const std::string body = error_of(with(plane_case, "density", "densty"));
  EXPECT_EQ(
      body.rfind("scratch.toml:16:1: unknown key \"densty\" in bodies.0, did you mean \"density\"? (known: name, shape",
                 0),
      0u)
      << body;
}

TEST(UnknownKeys, TablesToo) {
  const std::string error = error_of(with(plane_case, "[initial]", "[initail]"));
  EXPECT_EQ(error.rfind("scratch.toml:9:2: unknown key \"initail\", did you mean \"initial\"?", 0), 0u) << error;
  EXPECT_EQ(
      error_of(plane_case, {"tim.end=1"}).rfind("--set tim.end=1: unknown key \"tim\", did you mean \"time\"?", 0), 0u);
}

TEST(UnknownKeys, NestedTablesAndArrays) {
  const std::string error = error_of(plane_case, {"bodies.0.force.torqe=1"});
  EXPECT_EQ(error,
            "--set bodies.0.force.torqe=1: unknown key \"torqe\" in bodies.0.force, did you mean \"torque\"? (known: "
            "x, y, torque)");
  const std::string probe = error_of(plane_case + "[[probes]]\nposition = [0, 0]\nnmae = \"p\"\n");
  EXPECT_EQ(probe,
            "scratch.toml:19:1: unknown key \"nmae\" in probes.0, did you mean \"name\"? (known: name, position)");
}

TEST(UnknownKeys, KeyOfAnotherTable) {
  const std::string error = error_of("limiter = \"none\"\n" + plane_case);
  EXPECT_EQ(error.rfind("scratch.toml:1:1: unknown key \"limiter\", did you mean \"fluid.limiter\"?", 0), 0u) << error;
}

TEST(UnknownKeys, NothingNearGivesTheListAlone) {
  EXPECT_EQ(error_of(plane_case, {"time.qqqqqqqqqqqq=1"}),
            "--set time.qqqqqqqqqqqq=1: unknown key \"qqqqqqqqqqqq\" in time (known: end, cfl, step)");
}

}  // namespace
}  // namespace mortise
