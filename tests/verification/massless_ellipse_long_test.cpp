// The ellipse as the case has it, h = 1/160, and how the answer got there.
#include "verification/massless_ellipse_checks.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::set;

TEST(MasslessEllipseLong, FollowsThePublishedMotionAndConverges) {
  std::vector<std::vector<testing::EllipseAt>> motions;
  for (const double factor : {4.0, 8.0, 16.0}) {
    CaseRun<2> run("massless_ellipse", {set("grid.factor", factor)});
    motions.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_TRUE(run.run(testing::published_ellipse[k].time).finished()) << run.reason();
      motions.back().push_back(ellipse(run));
      if (factor < 16) continue;
      expect_ellipse(run, testing::published_ellipse[k], 0.005, 0.5);
      expect_ellipse(run, testing::independent_ellipse[k], 0.004, 0.3);
    }
  }
  for (std::size_t k = 0; k < 3; ++k)  // first order at shocks
    EXPECT_LE(distance(motions[2][k], motions[1][k]), 0.65 * distance(motions[1][k], motions[0][k])) << k;
}

TEST(MasslessEllipseLong, DensityOne) {
  std::vector<testing::EllipseAt> ends;
  for (const double factor : {4.0, 8.0, 16.0}) {
    CaseRun<2> run("massless_ellipse", {set("grid.factor", factor), "bodies.0.density=1"});
    ASSERT_TRUE(run.run().finished()) << run.reason();
    expect_ellipse(run, testing::heavy_ellipse, 0.005, 2);
    ends.push_back(ellipse(run));
  }
  EXPECT_LE(distance(ends[2], ends[1]), 0.65 * distance(ends[1], ends[0]));
  EXPECT_LE(std::abs(ends[2].degrees - ends[1].degrees), 0.1);
}

}  // namespace
}  // namespace mortise
