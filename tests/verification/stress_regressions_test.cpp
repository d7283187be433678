// Scenes that a random search (cases/study/stress_scenes.hpp) found to end badly, cut down to what it took.
#include <gtest/gtest.h>

#include "unit/cases/input/scratch_case.hpp"
#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

template <int Dim>
struct TextRun {
  explicit TextRun(const std::string& text) : run(scratch.write("scene.toml", text)) {}
  test::Scratch scratch;
  CaseRun<Dim> run;
};

std::string line(const std::string& rest, const std::string& grid = "factor = 4\nlow = -1\nhigh = 1") {
  return "dimension = 1\n[grid]\n" + grid + "\n" + rest;
}
std::string plane(const std::string& rest, const std::string& grid = "factor = 3\nlow = [-1, -1]\nhigh = [1, 1]") {
  return "[grid]\n" + grid + "\n" + rest;
}

// Walls that gain speed make every step a little too long; that was taken for an unstable coupling after 80 steps.
TEST(StressRegressions, CourantNumberOneWithMovingBodies) {
  TextRun<1> made(
      line("[time]\nend = 2\ncfl = 1\n[initial]\nkind = \"uniform\"\nstate = [1, 0, 0.7]\n"
           "[[bodies]]\nshape = \"slab\"\nwidth = 0.2\nposition = 0\nmass = 2\nforce.x = \"0.3*sin(3*t)\"\n"));
  made.run.run();
  EXPECT_TRUE(made.run.finished()) << made.run.reason();
  EXPECT_GT(made.run.simulation.steps(), 85);
}

// A body that moves with a uniform stream leaves it as it is, on its way through periodic sides too.
TEST(StressRegressions, SlabsCrossPeriodicSides) {
  TextRun<1> made(
      line("[time]\nend = 3\n[boundaries]\nleft = \"periodic\"\nright = \"periodic\"\n"
           "[initial]\nkind = \"uniform\"\nstate = [1, 1, 0.7]\n"
           "[[bodies]]\nshape = \"slab\"\nwidth = 0.2\nposition = 0.5\nmass = 2\nvelocity = 1\n"));
  made.run.run();
  ASSERT_TRUE(made.run.finished()) << made.run.reason();
  EXPECT_NEAR(made.run.simulation.bodies()[0].pose.position[0], 3.5, 1e-12);
  for (const ActiveCell<1>& cell : made.run.cells()) {
    EXPECT_NEAR(cell.W.density, 1, 1e-12);
    EXPECT_NEAR(cell.W.velocity[0], 1, 1e-12);
  }
}

TEST(StressRegressions, CirclesCrossPeriodicSides) {
  TextRun<2> made(plane(
      "[time]\nend = 1.5\n[boundaries]\nleft = \"periodic\"\nright = \"periodic\"\nbottom = \"periodic\"\ntop = "
      "\"periodic\"\n"
      "[initial]\nkind = \"uniform\"\nstate = [1, 1, 0.6, 0.7]\n"
      "[[bodies]]\nshape = \"circle\"\nradius = 0.25\nposition = [0.3, 0.4]\ndensity = 2\nvelocity = [1, 0.6]\n"));
  made.run.run();
  ASSERT_TRUE(made.run.finished()) << made.run.reason();
  double solid = 0;  // what is not gas is covered, wherever the body is
  for (const ActiveCell<2>& cell : made.run.cells()) {
    EXPECT_NEAR(cell.W.density, 1, 1e-11);
    EXPECT_NEAR(cell.W.velocity[0], 1, 1e-11);
    EXPECT_NEAR(cell.W.velocity[1], 0.6, 1e-11);
    solid += cell.volume;
  }
  EXPECT_GT(solid, 0);
  const std::vector<Point<2>> points{Point<2>(-0.2, -0.7), Point<2>(0.6, 0.5)};  // the first is in the circle now
  EXPECT_NEAR(made.run.simulation.bodies()[0].pose.position[0], 1.8, 1e-11);
  const auto samples = made.run.simulation.fluid().sample(points);
  EXPECT_FALSE(std::isfinite(samples[0][0]));
  EXPECT_NEAR(samples[1][0], 1, 1e-11);
}

TEST(StressRegressions, BodiesMeetAcrossPeriodicSides) {
  TextRun<1> made(
      line("[time]\nend = 1\n[boundaries]\nleft = \"periodic\"\nright = \"periodic\"\n"
           "[initial]\nkind = \"uniform\"\nstate = [1e-6, 0, 1e-6]\n"
           "[[bodies]]\nshape = \"slab\"\nwidth = 0.2\nposition = 0.6\nmass = 1\nvelocity = 1\n"
           "[[bodies]]\nshape = \"slab\"\nwidth = 0.2\nposition = -0.6\nmass = 1\n"));
  made.run.run();
  ASSERT_TRUE(made.run.finished()) << made.run.reason();
  EXPECT_NEAR(made.run.simulation.bodies()[0].y[0], 0, 1e-3);
  EXPECT_NEAR(made.run.simulation.bodies()[1].y[0], 1, 1e-3);
}

TEST(StressRegressions, AHalfSpaceHasNoPlaceInAPeriodicDomain) {
  const std::string error =
      test::error_of(line("[time]\nend = 1\n[boundaries]\nleft = \"periodic\"\nright = \"periodic\"\n[initial]\nkind = "
                          "\"uniform\"\nstate = [1, 0, 1]\n"
                          "[[bodies]]\nshape = \"half_space\"\nside = \"left\"\nposition = 0\nmass = 1\n"));
  EXPECT_NE(error.find("bodies.0.shape = \"half_space\" cannot be in a periodic domain"), std::string::npos) << error;
}

TEST(StressRegressions, APistonThatLeavesTheDomainIsNamed) {
  TextRun<1> made(
      line("[time]\nend = 3\n[initial]\nkind = \"uniform\"\nstate = [1, 0, 1]\n"
           "[[bodies]]\nshape = \"half_space\"\nside = \"left\"\nposition = -0.5\nmass = 0.1\nvelocity = -1\n"));
  made.run.run();
  EXPECT_NE(made.run.reason().find("the surface of half_space_0 leaves the domain at x = -1.0"), std::string::npos)
      << made.run.reason();
}

// A supersonic stream that is stopped by a wall in a stiffened gas next to its tension limit.
TEST(StressRegressions, GasOfNextToNoPressureTakesStepsOfFirstOrder) {
  TextRun<1> made(
      "dimension = 1\ngravity = 0.4682\n[grid]\nfactor = 10\nlow = -1.151\nhigh = 1.151\n[time]\nend = 0.5504\n"
      "[gas]\ngamma = 3\np_inf = 0.33\n[boundaries]\nleft = \"inflow\"\nright = \"outflow\"\n"
      "[initial]\nkind = \"uniform\"\nstate = [1, 3.284, 0.0033333333333332993]\n"
      "[[bodies]]\nshape = \"half_space\"\nside = \"left\"\nposition = -0.43076003\nmass = 0.1476\n");
  made.run.run();
  EXPECT_TRUE(made.run.finished()) << made.run.reason();
  EXPECT_GT(made.run.simulation.first_order_steps(), 0);
}

// Contact points of circles are off by what a polygon is off a circle: that spun light ones beyond all bounds.
TEST(StressRegressions, LightCirclesAreNotSpunByContacts) {
  TextRun<2> made(
      plane("[time]\nend = 0.15\n[boundaries]\nleft = \"inflow\"\nbottom = \"wall\"\ntop = \"wall\"\n"
            "[initial]\nkind = \"shock\"\nahead = [1, 0, 0, 0.7142857142857143]\nmach = 3\nposition = -0.9\n"
            "[[bodies]]\nshape = \"circle\"\nradius = 0.2136\nposition = [-0.5291, 0.03]\nmass = 1.157e-8\ninertia = "
            "1.576e-10\n"
            "[[bodies]]\nshape = \"circle\"\nradius = 0.2624\nposition = [0.06, 0]\ndensity = 4.57\nangular_velocity = "
            "-5.418\n"));
  made.run.run();
  EXPECT_TRUE(made.run.finished()) << made.run.reason();
  EXPECT_GT(made.run.simulation.contacts(), 0);
  EXPECT_LT(std::abs(made.run.simulation.bodies()[0].y[2]), 0.1);
  EXPECT_NEAR(made.run.simulation.bodies()[1].y[2], -5.418, 1e-3);
}

// The unit of time of the first look ahead was the domain's largest coordinate: nought here.
TEST(StressRegressions, DomainsMayEndAtTheOrigin) {
  TextRun<1> made(
      line("[time]\nend = 0.5\n[initial]\nkind = \"uniform\"\nstate = [1, 0, 0.7]\n"
           "[[bodies]]\nshape = \"slab\"\nwidth = 0.2\nposition = -1\nmotion.x = \"0.1*sin(2*t)\"\n",
           "factor = 4\nlow = -2\nhigh = 0"));
  made.run.run();
  EXPECT_TRUE(made.run.finished()) << made.run.reason();
  for (const ActiveCell<1>& cell : made.run.cells()) EXPECT_TRUE(cell.W.density > 0.5 && cell.W.density < 2);
}

// What cannot begin is wrong with the input.
TEST(StressRegressions, SolidsTooThinForTheirGridsAreRefused) {
  const test::Scratch scratch;
  const std::string file =
      scratch.write("thin.toml", plane("[time]\nend = 0.1\n[initial]\nkind = \"uniform\"\nstate = [1, 0, 0, "
                                       "1]\n[[solids]]\nshape = \"stick\"\nsize = [0.1288, 0.6279]\nfillet = 0.0525\n"
                                       "position = [-0.00759, 0.2781]\nangle = 161.7\nmaterial = {law = "
                                       "\"neo_hookean\", density = 1, lambda = 1, mu = 1}\n"));
  try {
    CaseRun<2> run(file);
    FAIL() << "it was taken";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("use finer cells (grid.factor)"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace mortise
