#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using test::error_of, test::line_case, test::plane_case, test::read_text, test::Scratch, test::with;

const std::string weightless = with(plane_case, "density = 1.0\n", "");

TEST(BodyChecks, MassOrDensityOfWhatMovesFreely) {
  EXPECT_EQ(error_of(weightless),
            "scratch.toml:13:1: the key \"bodies.0.density\" is missing: a number ≥ 0 (or mass and inertia) of a body "
            "that moves freely");
  EXPECT_EQ(error_of(weightless + "mass = 1\n"),
            "scratch.toml:13:1: the key \"bodies.0.inertia\" is missing: a number ≥ 0 (or density) of a body that "
            "turns freely");
  EXPECT_EQ(error_of(weightless + "mass = 1\nfixed = [\"angle\"]\n"), "");
  EXPECT_EQ(error_of(weightless + "inertia = 1\nfixed = [\"x\", \"y\"]\n"), "");
  EXPECT_EQ(error_of(weightless + "fixed = [\"x\", \"y\", \"angle\"]\n"), "");
  EXPECT_EQ(error_of(weightless + "fixed = [\"angle\"]\nmotion = {x = \"t\", y = \"0\"}\n"), "");
  EXPECT_EQ(
      error_of(weightless + "inertia = 1\n").rfind("scratch.toml:13:1: the key \"bodies.0.density\" is missing", 0),
      0u);
}

TEST(BodyChecks, OneDimension) {
  EXPECT_EQ(error_of(line_case, {"bodies.0.shape=half_space", "bodies.0.side=left"}), "");
  EXPECT_EQ(error_of(line_case, {"bodies.0.shape=half_space", "bodies.0.side=left", "bodies.0.density=1"}),
            "--set bodies.0.density=1: bodies.0.density cannot be used, a half space has no volume: give mass instead");
  EXPECT_EQ(error_of(line_case, {"bodies.0.inertia=1"}),
            "--set bodies.0.inertia=1: bodies.0.inertia is not there in 1D");
  EXPECT_EQ(error_of(line_case, {"bodies.0.motion.y=t"}),
            "--set bodies.0.motion.y=t: bodies.0.motion.y is not there in 1D");
  EXPECT_EQ(error_of(line_case, {"bodies.0.fixed=[\"y\"]"}).find("bodies.0.fixed must be [\"x\"] in 1D, not \"y\""),
            std::string("--set bodies.0.fixed=[\"y\"]: ").size());
  EXPECT_EQ(error_of(line_case, {"bodies.0.shape=circle", "bodies.0.radius=0.1"}),
            "--set bodies.0.shape=circle: bodies.0.shape = \"circle\" is not there in 1D: use slab or half_space");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.shape=slab", "bodies.0.width=0.1"}),
            "--set bodies.0.shape=slab: bodies.0.shape = \"slab\" is not there in 2D: use circle, ellipse, stick, "
            "rectangle, polygon or spline");
}

TEST(BodyChecks, PrescribedMotion) {
  EXPECT_EQ(error_of(plane_case, {"bodies.0.motion.x=1 + t"}),
            "--set bodies.0.motion.x=1 + t: bodies.0.motion.x must be 0 at t = 0, as a displacement from there, not 1");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.motion.x=t", "bodies.0.fixed=[\"x\"]"}),
            "--set bodies.0.motion.x=t: bodies.0.motion.x moves what bodies.0.fixed holds: give one or the other");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.motion.x=t", "bodies.0.velocity=[1, 0]"}),
            "--set bodies.0.velocity=[1, 0]: bodies.0.velocity has no effect: x has a prescribed motion");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.fixed=[\"angle\"]", "bodies.0.force.torque=1"}),
            "--set bodies.0.force.torque=1: bodies.0.force.torque has no effect: angle is fixed");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.force.x=1/t"}),
            "--set bodies.0.force.x=1/t: bodies.0.force.x = \"1/t\" is not finite at t = 0");
}

TEST(BodyChecks, TraditionalNeedsMass) {
  EXPECT_EQ(error_of(plane_case, {"scheme=traditional"}), "");
  EXPECT_EQ(error_of(plane_case, {"scheme=traditional", "bodies.0.density=0"}),
            "--set scheme=traditional: scheme = \"traditional\" cannot move bodies.0, whose density is 0, as it "
            "divides by it: use "
            "rigid, or give it density");
  EXPECT_NE(
      error_of(plane_case, {"scheme=traditional", "bodies.0.mass=1", "bodies.0.inertia=0"}).find("whose inertia is 0"),
      std::string::npos);
  EXPECT_EQ(error_of(plane_case,
                     {"scheme=traditional", "bodies.0.mass=1", "bodies.0.inertia=0", "bodies.0.fixed=[\"angle\"]"}),
            "");
}

TEST(BodyChecks, ExactSurfaceNeedsPrescribedMotion) {
  EXPECT_EQ(error_of(plane_case, {"bodies.0.surface=exact"}),
            "--set bodies.0.surface=exact: bodies.0.surface = \"exact\" needs an exact solution: the key \"exact\" is "
            "missing");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.surface=exact", "exact=uniform"}),
            "--set bodies.0.surface=exact: bodies.0.surface = \"exact\" feels no force: prescribe the motion of the "
            "body, or fix it");
  EXPECT_EQ(
      error_of(plane_case, {"bodies.0.surface=exact", "exact=uniform", "bodies.0.fixed=[\"x\", \"y\", \"angle\"]"}),
      "");
}

TEST(BodyChecks, Fillets) {
  const std::string stick =
      with(plane_case, "\"circle\"\nradius = 0.25", "\"stick\"\nsize = [0.1, 0.5]\nfillet = 0.06");
  EXPECT_EQ(
      error_of(stick),
      "scratch.toml:16:10: bodies.0.fillet = 0.06 is not allowed: it must be at most half the shorter side, 0.05");
  EXPECT_EQ(error_of(stick, {"bodies.0.fillet=0.05"}), "");
  const std::string polygon =
      with(stick, "\"stick\"\nsize = [0.1, 0.5]", "\"polygon\"\ncorners = [[0, 0], [1, 0], [0, 1]]");
  EXPECT_EQ(read_text(polygon).bodies[0].corners[2][1], 1.0);
  EXPECT_NE(error_of(polygon, {"bodies.0.corners=[[0, 0], [1, 0]]"})
                .find("bodies.0.corners must be an array of at least 3 points"),
            std::string::npos);
}

TEST(BodyChecks, SplineFile) {
  const Scratch scratch;
  const std::string spline = with(plane_case, "\"circle\"\nradius = 0.25", "\"spline\"\npoints = \"wing.dat\"");
  const std::string path = scratch.write("spline.toml", spline);
  const std::string file = (scratch.folder() / "wing.dat").string();
  try {
    read_case(path, {}, "nowhere");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), path + ":15:10: bodies.0.points: the file \"" + file + "\" cannot be read");
  }
  scratch.write("wing.dat", "0 0\n1 0\n1 1\n0 1\n");
  EXPECT_EQ(read_case(path, {}, "nowhere").bodies[0].points, file);
}

}  // namespace
}  // namespace mortise
