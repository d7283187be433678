#include "mortise/fluid/exact_flux.hpp"

#include "unit/fluid/riemann_checks.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::gamma_air, testing::Plane;

TEST(ExactFlux, IsConsistent) { testing::check_consistency<ExactRiemann>(gamma_air); }
TEST(ExactFlux, IsUpwindInSupersonicFlow) { testing::check_upwinding<ExactRiemann>(gamma_air); }
TEST(ExactFlux, ScalesWithTheFaceAndIsGalileanInvariant) { testing::check_scaling_and_frame<ExactRiemann>(gamma_air); }
TEST(ExactFlux, LanesAgree) { testing::check_lanes<ExactRiemann>(gamma_air); }
TEST(ExactFlux, MirroredProblemHasTheMirroredFlux) { testing::check_mirror<ExactRiemann>(gamma_air, 1e-13); }

TEST(ExactFlux, FaceMovingWithTheContactSeesTheReferenceStarState) {
  for (const auto& row : testing::reference_table("riemann.csv")) {
    const auto value = [&](const char* column) { return testing::number(row, column); };
    const double u = value("ustar"), p = value("pstar");
    const Primitive<1> L{value("rhoL"), {value("uL")}, value("pL")}, R{value("rhoR"), {value("uR")}, value("pR")};
    const Conserved<1> F = ExactRiemann::flux(L, R, SlidingFace(u), gamma_air);
    const double mass_scale = (value("rhostarL") + value("rhostarR")) * (std::abs(u) + 1);
    EXPECT_NEAR(F.density, 0, 1e-12 * mass_scale);
    EXPECT_NEAR(F.momentum[0], p, 1e-11 * (p + mass_scale));
    EXPECT_NEAR(F.energy, p * u, 1e-11 * (p * std::abs(u) + p + mass_scale));
  }
}

TEST(ExactFlux, TangentialVelocityComesFromUpwindOfTheContact) {
  const Plane L{1, {0.5, 3}, 1}, R{1, {0.5, -7}, 1};
  const Conserved<2> F = ExactRiemann::flux(L, R, AxisFace<0>{}, gamma_air);
  EXPECT_NEAR(F.momentum[1], 3 * F.density, 1e-14);
}

TEST(ExactFlux, NothingPassesAVacuum) {
  const Conserved<1> F =
      ExactRiemann::flux(Primitive<1>{1, {-20}, 1}, Primitive<1>{1, {20}, 1}, AxisFace<0>{}, gamma_air);
  EXPECT_EQ(F.density, 0);
  EXPECT_EQ(F.momentum[0], 0);
  EXPECT_EQ(F.energy, 0);
}

TEST(ExactFlux, InvalidStateGivesNaN) {
  const Conserved<1> F =
      ExactRiemann::flux(Primitive<1>{1, {0}, -1}, Primitive<1>{1, {0}, 1}, AxisFace<0>{}, gamma_air);
  EXPECT_TRUE(std::isnan(F.density));
}

}  // namespace
}  // namespace mortise
