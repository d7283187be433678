// The elastic piston, light and heavy, and turned on finer grids.
#include "verification/elastic_piston_checks.hpp"

namespace mortise {
namespace {

using namespace testing;

TEST(ElasticPistonLong, LightAndHeavyPistonsAreOfSecondOrder) {
  for (const double scale : {0.01, 0.1, 10.0}) expect_order({set("solid.scale", scale)}, 16, 64, 1.9, along_fields);
}

// Two refinements nearer the asymptotic range than 8 to 16, where the velocity of the gas has order 1.76.
TEST(ElasticPistonLong, TurnedStripsAreOfSecondOrder) {
  for (const double angle : {30.0, 45.0}) expect_order(strip(angle, 0.2), 16, 32, 1.85, turned_fields);
}

TEST(ElasticPistonLong, FacesThatDoNotMatchKeepTheOrder) {
  expect_order(strip(30, 0.2) + Overrides{"coupling.face_ratio=1.37"}, 8, 32, 1.75, turned_fields);
}

}  // namespace
}  // namespace mortise
