#include "mortise/fluid/hlle.hpp"

#include "unit/fluid/riemann_checks.hpp"

namespace mortise {
namespace {

using testing::gamma_air;

TEST(Hlle, IsConsistent) { testing::check_consistency<Hlle>(gamma_air); }
TEST(Hlle, IsUpwindInSupersonicFlow) { testing::check_upwinding<Hlle>(gamma_air); }
TEST(Hlle, ScalesWithTheFaceAndIsGalileanInvariant) { testing::check_scaling_and_frame<Hlle>(gamma_air); }
TEST(Hlle, LanesAgree) { testing::check_lanes<Hlle>(gamma_air); }
TEST(Hlle, MirroredProblemHasTheMirroredFlux) { testing::check_mirror<Hlle>(gamma_air, 1e-14); }

TEST(Hlle, ExactNumbers) {
  // Symmetric collision at rest in the mean: s = ±s_R by symmetry, F = (0, p + ρu² + s ρu, 0) with the mean state at
  // rest.
  const Primitive<1> L{1, {1}, 1}, R{1, {-1}, 1};
  const double c = std::sqrt(gamma_air), roe = std::sqrt(gamma_air + 0.5 * 0.25 * 4);  // c̃² = c² + ½ · ¼ · (Δu)²
  const double s = std::max(c - 1, roe);
  const Conserved<1> F = Hlle::flux(L, R, AxisFace<0>{}, gamma_air);
  EXPECT_NEAR(F.density, 0, 1e-15);
  EXPECT_NEAR(F.momentum[0], 1 + 1 + s, 1e-14);
  EXPECT_NEAR(F.energy, 0, 1e-15);
}

}  // namespace
}  // namespace mortise
