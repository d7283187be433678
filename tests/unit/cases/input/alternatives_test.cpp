#include "mortise/cases/input/alternatives.hpp"

#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using test::error_of, test::line_case, test::plane_case, test::read_text, test::with;

TEST(Alternatives, KeysOfAnotherShape) {
  EXPECT_EQ(error_of(with(plane_case, "radius = 0.25", "radius = 0.25\nsize = [1, 1]")),
            "scratch.toml:16:1: the key \"bodies.0.size\" does not belong to shape = \"circle\" (which takes radius)");
  EXPECT_EQ(error_of(with(plane_case, "radius = 0.25\n", "")),
            "scratch.toml:13:1: the key \"bodies.0.radius\" is missing: shape = \"circle\" needs radius");
}

TEST(Alternatives, KeysOfAnotherInitialKind) {
  EXPECT_EQ(error_of(plane_case, {"initial.mach=2"}),
            "--set initial.mach=2: the key \"initial.mach\" does not belong to kind = \"uniform\" (which takes state)");
  EXPECT_EQ(error_of(plane_case, {"initial.kind=shock"}),
            "scratch.toml:9:1: the key \"initial.ahead\" is missing: kind = \"shock\" needs ahead");
  const std::string shock = with(plane_case, "kind = \"uniform\"\nstate", "kind = \"shock\"\nahead");
  EXPECT_EQ(
      error_of(shock),
      "scratch.toml:9:1: the key \"initial.mach\" is missing: the Mach number of the shock, > 1 (or initial.behind)");
  EXPECT_EQ(
      error_of(shock, {"initial.mach=2", "initial.behind=[2, 1, 0, 3]"}),
      "--set initial.behind=[2, 1, 0, 3]: initial.mach and initial.behind are both given: one of them says it all");
}

TEST(Alternatives, DensityOrMass) {
  EXPECT_EQ(error_of(with(plane_case, "density = 1.0", "density = 1.0\nmass = 1.0")),
            "scratch.toml:17:8: bodies.0.density and bodies.0.mass are both given: give one or the other");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.density=0", "bodies.0.inertia=0"}).substr(0, 27),
            "--set bodies.0.inertia=0: b");
}

TEST(Alternatives, CommandLineSupersedesTheFile) {
  const std::string weighed = with(plane_case, "density = 1.0", "mass = 1.0\ninertia = 0.5");
  const CaseDescription light = read_text(weighed, {"bodies.0.density=0"});
  EXPECT_EQ(light.bodies[0].density, 0.0);
  EXPECT_FALSE(light.bodies[0].mass || light.bodies[0].inertia);
  const CaseDescription heavy = read_text(plane_case, {"bodies.0.mass=3", "bodies.0.inertia=2"});
  EXPECT_FALSE(heavy.bodies[0].density);
  EXPECT_EQ(heavy.bodies[0].mass, 3.0);
  const CaseDescription heavier = read_text(weighed, {"bodies.0.mass=3"});
  EXPECT_EQ(heavier.bodies[0].inertia, 0.5);
}

TEST(Alternatives, ShapeAndKindSupersedeTheirKeys) {
  const CaseDescription ellipse = read_text(plane_case, {"bodies.0.shape=ellipse", "bodies.0.semi_axes=[0.5, 0.25]"});
  EXPECT_EQ(ellipse.bodies[0].radius, 0.0);
  EXPECT_EQ(ellipse.bodies[0].semi_axes[1], 0.25);
  const std::string riemann = with(line_case, "kind = \"uniform\"\nstate = [1, 0, 1]",
                                   "kind = \"riemann\"\nleft = [1, 0, 1]\nright = [2, 0, 2]");
  const CaseDescription shock = read_text(riemann, {"initial.kind=shock", "initial.ahead=[1, 0, 1]", "initial.mach=2"});
  EXPECT_EQ(shock.initial.right[0], 1.0);
  EXPECT_NEAR(shock.initial.left[3], 4.5, 1e-15);
}

TEST(Alternatives, MotionSupersedesTheForceAlongIt) {
  const std::string forced = line_case + "force = {x = \"t\"}\n";
  EXPECT_EQ(read_text(forced).bodies[0].force_x, "t");
  const CaseDescription moved = read_text(forced, {"bodies.0.motion.x=-t^4/4"});
  EXPECT_EQ(moved.bodies[0].force_x, "");
  EXPECT_EQ(moved.bodies[0].motion_x, "-t^4/4");
}

}  // namespace
}  // namespace mortise
