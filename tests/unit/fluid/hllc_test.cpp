#include "mortise/fluid/hllc.hpp"

#include "mortise/fluid/exact_riemann.hpp"
#include "unit/fluid/riemann_checks.hpp"

namespace mortise {
namespace {

using testing::gamma_air, testing::Plane;

TEST(Hllc, IsConsistent) { testing::check_consistency<Hllc>(gamma_air); }
TEST(Hllc, IsUpwindInSupersonicFlow) { testing::check_upwinding<Hllc>(gamma_air); }
TEST(Hllc, ScalesWithTheFaceAndIsGalileanInvariant) { testing::check_scaling_and_frame<Hllc>(gamma_air); }
TEST(Hllc, LanesAgree) { testing::check_lanes<Hllc>(gamma_air); }
TEST(Hllc, MirroredProblemHasTheMirroredFluxToTheBit) { testing::check_mirror<Hllc>(gamma_air, 0); }

TEST(Hllc, ContactAtRestIsExact) {
  const Conserved<2> F = Hllc::flux(Plane{1, {0, 0.5}, 2}, Plane{0.1, {0, -3}, 2}, AxisFace<0>{}, gamma_air);
  EXPECT_EQ(F.density, 0);
  EXPECT_EQ(F.momentum[0], 2);
  EXPECT_EQ(F.momentum[1], 0);
  EXPECT_EQ(F.energy, 0);
}

TEST(Hllc, ContactMovingWithTheFaceExchangesOnlyPressureWork) {
  const double w = 0.75;
  const Conserved<1> F = Hllc::flux(Primitive<1>{1, {w}, 2}, Primitive<1>{0.1, {w}, 2}, SlidingFace(w), gamma_air);
  EXPECT_EQ(F.density, 0);
  EXPECT_EQ(F.momentum[0], 2);
  EXPECT_EQ(F.energy, 2 * w);
}

TEST(Hllc, RecedingStatesNearVacuumGiveFiniteFluxes) {
  const Conserved<2> F = Hllc::flux(Plane{1e-8, {-20, 0}, 1e-9}, Plane{1e-8, {20, 0}, 1e-9}, AxisFace<0>{}, gamma_air);
  EXPECT_EQ(F.density, 0);
  EXPECT_TRUE(std::isfinite(F.momentum[0]) && std::isfinite(F.energy));
}

TEST(Hllc, ApproachesTheExactFluxForWeakWaves) {
  const Plane L{1, {0.1, 0}, 1}, R{1.001, {0.099, 0}, 1.001};
  const Primitive<1> star = sample(Primitive<1>{1, {0.1}, 1}, Primitive<1>{1.001, {0.099}, 1.001}, gamma_air, 0);
  const PlaneFace<double> face(1, 0, 0);
  testing::expect_near(Hllc::flux(L, R, face, gamma_air),
                       testing::physical_flux({star.density, {star.velocity[0], 0}, star.pressure}, face, gamma_air),
                       3e-6);
}

}  // namespace
}  // namespace mortise
