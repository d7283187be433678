// From descriptions of elastic solids to set-ups: grids that meet, sides, states, interfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/cases/scene/scene.hpp"
#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using Overrides = std::vector<std::string>;

const std::string cases_root = MORTISE_SOURCE_DIR "/cases";

Scene<2> scene_of(const std::string& name, const Overrides& overrides) {
  return build_scene<2>(read_case(name, overrides, cases_root));
}

const GrownGrid& gas_grid(const Scene<2>& scene, std::size_t solid = 0) {
  const FittedBody<2>& body = scene.setup.fluid.bodies[scene.setup.solids[solid].interface->body];
  return body.mesh ? *body.mesh : body.shape.atlas->grid();
}

/// The gas's first layer of nodes is the solid's, in opposite order (node 0 of a grid that repeats itself a period
/// off).
void expect_matching(const Scene<2>& scene, std::size_t solid = 0) {
  const GrownGrid &ours = *scene.setup.solids[solid].elastic.fitted, &theirs = gas_grid(scene, solid);
  ASSERT_EQ(ours.along, theirs.along);
  for (int i = 0; i < ours.row(); ++i) {
    const Point<2> other =
        i == 0 && ours.periodic ? Point<2>(theirs.node(0, 0) - ours.period) : theirs.node(ours.along - i, 0);
    EXPECT_LT((ours.node(i, 0) - other).norm(), 1e-12) << i;
  }
}

TEST(SolidScene, PistonOnALineIsAStripFourCellsWide) {
  const CaseDescription c = read_case("elastic_piston", {"grid.factor=2"}, cases_root);
  EXPECT_EQ(scene_dimension(c), 2);
  const Scene<2> scene = build_scene<2>(c);
  ASSERT_EQ(scene.setup.solids.size(), 1u);
  EXPECT_EQ(scene.setup.fluid.cells[0], 0);
  const GrownGrid &gas = gas_grid(scene), &solid = *scene.setup.solids[0].elastic.fitted;
  EXPECT_EQ(gas.along, 4);
  EXPECT_EQ(gas.layers, 20);
  EXPECT_EQ(solid.layers, 20);
  EXPECT_TRUE(gas.periodic && solid.periodic);
  expect_matching(scene);
  EXPECT_EQ(first_folded_cell(gas), (Index<2>{-1, -1}));
  EXPECT_EQ(first_folded_cell(solid), (Index<2>{-1, -1}));
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(gas.node(i, 0).x(), 0, 1e-15);
    EXPECT_NEAR(gas.node(i, 20).x(), 1, 1e-15);
    EXPECT_NEAR(solid.node(i, 20).x(), -1, 1e-15);
  }
}

TEST(SolidScene, PistonStartsAsTheExactSolution) {
  const Scene<2> scene = scene_of("elastic_piston", {"grid.factor=2"});
  const SolidSetup& solid = scene.setup.solids[0];
  const Point<2> X(-0.3, 0.01);
  const ExactSolid exact = scene.exact->solid(X, 0);
  const ElasticState state = solid.initial(X, 0);
  EXPECT_EQ(state[0], exact.velocity.x());
  EXPECT_EQ(state[2], exact.stress(0, 0));
  EXPECT_EQ(state[5], exact.displacement.x());
  EXPECT_NE(state[0], 0);  // waves are under way
  EXPECT_EQ(solid.elastic.fitted_sides[2].kind, ElasticBoundary::interface);
  EXPECT_EQ(solid.elastic.fitted_sides[3].kind, ElasticBoundary::exact);
  EXPECT_EQ(scene.setup.fluid.bodies[0].sides[3], BoundaryKind::exact);
  EXPECT_EQ(solid.interface->scheme, "projection");
  EXPECT_EQ(solid.interface->far.size(), 4u);
  EXPECT_NEAR(solid.interface->options.reference_pressure, 1 / 14.0, 1e-15);
}

TEST(SolidScene, PistonTurnedInThePlane) {
  const Scene<2> scene =
      scene_of("elastic_piston",
               {"grid.factor=2", "dimension=2", "grid.angle=30", "grid.low=[-0.2, 0]", "grid.high=[0.3, 1]",
                "initial.state=[0.1, 0, 0, 0.07]", "boundaries={left=\"exact\", right=\"wall\", top=\"exact\"}",
                "solids.0.sides={left=\"exact\", right=\"slip\", back=\"exact\"}"});
  const GrownGrid& gas = gas_grid(scene);
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  EXPECT_EQ(gas.along, 10);
  EXPECT_FALSE(gas.periodic);
  EXPECT_LT((gas.node(0, 0) - Point<2>(-0.2 * s, 0.2 * c)).norm(), 1e-15);
  EXPECT_LT((gas.node(10, 20) - Point<2>(0.3 * s + c, -0.3 * c + s)).norm(), 1e-14);
  expect_matching(scene);
  // the solid's grid runs the other way
  EXPECT_EQ(scene.setup.solids[0].elastic.fitted_sides[0].kind, ElasticBoundary::slip);
  EXPECT_EQ(scene.setup.solids[0].elastic.fitted_sides[1].kind, ElasticBoundary::exact);
  EXPECT_EQ(scene.setup.fluid.bodies[0].sides[0], BoundaryKind::exact);
  EXPECT_EQ(scene.setup.fluid.bodies[0].sides[1], BoundaryKind::wall);
}

TEST(SolidScene, FacesNeedNotMatch) {
  const Overrides plane = {"grid.factor=4",
                           "dimension=2",
                           "grid.low=[0, 0]",
                           "grid.high=[1, 1]",
                           "initial.state=[0.1, 0, 0, 0.07]",
                           "boundaries={left=\"exact\", right=\"exact\", top=\"exact\"}",
                           "solids.0.sides={left=\"exact\", right=\"exact\", back=\"exact\"}",
                           "coupling.face_ratio=1.37"};
  const Scene<2> strip = scene_of("elastic_piston", plane);
  EXPECT_EQ(strip.setup.solids[0].elastic.fitted->along, 40);
  EXPECT_EQ(gas_grid(strip).along, 54);
  const Scene<2> shell = scene_of("radial_shell", {"exact=none", "coupling.face_ratio=1.37"});
  EXPECT_EQ(shell.setup.solids[0].elastic.fitted->along, 124);
  EXPECT_EQ(gas_grid(shell).along, 170);
  EXPECT_NEAR(gas_grid(shell).node(0, 0).x(), 0.5, 1e-12);
}

TEST(SolidScene, ShellAroundAGasDisk) {
  const Scene<2> scene = scene_of("radial_shell", {"exact=none"});
  const SolidSetup& solid = scene.setup.solids[0];
  EXPECT_GT(scene.setup.fluid.cells[0], 0);
  EXPECT_TRUE(solid.interface->inward);
  EXPECT_TRUE(scene.setup.fluid.bodies[0].shape.atlas->inward());
  EXPECT_TRUE(solid.interface->far.empty());
  expect_matching(scene);
  EXPECT_EQ(solid.elastic.fitted->layers, 20);
  EXPECT_NEAR(solid.elastic.fitted->node(7, 20).norm(), 1, 1e-14);
  const ElasticSide& outer = solid.elastic.fitted_sides[3];
  EXPECT_EQ(outer.kind, ElasticBoundary::traction);
  const Point<2> N(0.6, 0.8);
  EXPECT_NEAR(outer.value(N, N, 0.5).x(), -0.05 * 0.6, 1e-15);
  EXPECT_NEAR(outer.value(N, N, 0.5).y(), -0.05 * 0.8, 1e-15);
  EXPECT_EQ(outer.value(N, N, 1.5).norm(), 0);
}

TEST(SolidScene, SticksInAGas) {
  const CaseDescription c = read_case("shock_deformable_sticks", {"grid.factor=4"}, cases_root);
  const Scene<2> scene = build_scene<2>(c);
  ASSERT_EQ(scene.setup.solids.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    expect_matching(scene, k);
    const ElasticSetup& elastic = scene.setup.solids[k].elastic;
    EXPECT_EQ(first_folded_cell(*elastic.fitted), (Index<2>{-1, -1})) << k;
    EXPECT_TRUE(elastic.atlas->inward());
    for (const Point<2>& node : elastic.fitted->nodes) EXPECT_TRUE(elastic.domain.contains(node));
    Point<2> middle = Point<2>::Zero();
    for (int i = 0; i < elastic.fitted->along; ++i) middle += elastic.fitted->node(i, 0) / elastic.fitted->along;
    EXPECT_NEAR(middle.x(), c.solids[k].position[0], 1e-9);
    EXPECT_NEAR(middle.y(), c.solids[k].position[1], 1e-9);
  }
}

TEST(SolidScene, RigidBodiesComeFirst) {
  const std::string body = "[[bodies]]\nshape = \"circle\"\nradius = 0.2\nposition = [0.6, 0]\ndensity = 1\n";
  const CaseDescription sticks = read_case("shock_deformable_sticks", {"grid.factor=4"}, cases_root);
  const Scene<2> scene = build_scene<2>(test::read_text(sticks.text + body, {"grid.factor=4"}));
  ASSERT_EQ(scene.setup.fluid.bodies.size(), 4u);
  EXPECT_EQ(scene.setup.fluid.bodies[0].name, "circle_0");
  EXPECT_EQ(scene.setup.bodies.size(), 1u);
  EXPECT_EQ(scene.setup.scheme, "rigid");
  EXPECT_EQ(scene.setup.solids[0].interface->body, 1u);
  EXPECT_EQ(scene.setup.solids[2].interface->body, 3u);
  EXPECT_EQ(scene.setup.solids[2].interface->scheme, "projection");
}

TEST(SolidScene, PlateWithAHole) {
  const Scene<2> scene = scene_of("cylinder_in_solid", {"grid.factor=2"});
  const ElasticSetup& elastic = scene.setup.solids[0].elastic;
  expect_matching(scene);
  EXPECT_FALSE(elastic.atlas->inward());
  EXPECT_EQ(elastic.cells[0], 100);
  EXPECT_EQ(elastic.sides[0].kind, ElasticBoundary::exact);
  EXPECT_EQ(elastic.sides[1].kind, ElasticBoundary::displacement);
  EXPECT_EQ(elastic.sides[3].kind, ElasticBoundary::slip);
  // the wave: compressed and moving behind its front, which moves with c_p = √3
  const double c = std::sqrt(3.0);
  const ElasticState behind = elastic.exact({-2, 0.3}, 0), ahead = elastic.exact({-1.4, 0}, 0);
  EXPECT_NEAR(behind[0], 0.1 * c, 1e-15);
  EXPECT_NEAR(behind[2], -0.3, 1e-15);
  EXPECT_NEAR(behind[4], -0.1, 1e-15);
  EXPECT_NEAR(behind[5], 0.05, 1e-15);
  EXPECT_EQ(ahead, ElasticState{});
  EXPECT_NEAR(elastic.exact({-1.4, 0}, 1)[5], 0.1 * (c - 0.1), 1e-15);
  EXPECT_EQ(scene.setup.solids[0].initial({-1.4, 0}, 1), ElasticState{});
}

TEST(SolidScene, SpinningDiskAndFormula) {
  const Scene<2> disk =
      scene_of("rotating_elastic_disk", {"exact=none", "grid.factor=1", "solids.0.material.law=neo_hookean"});
  const ElasticState state = disk.setup.solids[0].initial({0.5, 0.25}, 0);
  const ElasticState expected = {-0.025, 0.05, 1, 0, 0, 1, 0, 0};
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(state[k], expected[k], 1e-16) << k;
  const auto velocity = disk.setup.solids[0].interface->velocity;
  EXPECT_NEAR(velocity({1, 0}).y(), 0.1, 1e-16);
  EXPECT_FALSE(disk.setup.solids[0].interface->displacement);

  const Overrides stretch = {
      "exact=none", "solids.0.material.law=neo_hookean",
      "solids.0.initial={kind=\"formula\", displacement=[\"0.1*x\", \"0.2*x*y\"], velocity=[\"y\", 0]}"};
  const ElasticState bent = scene_of("plane_waves", stretch).setup.solids[0].initial({0.5, 0.25}, 0);
  const ElasticState wanted = {0.25, 0, 1.1, 0, 0.05, 1.1, 0.05, 0.025};
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(bent[k], wanted[k], 1e-10) << k;
}

TEST(SolidScene, SolidsAloneHaveNoGas) {
  const Scene<2> scene = scene_of("annulus_modes", {});
  EXPECT_EQ(scene.setup.fluid.cells[0], 0);
  EXPECT_TRUE(scene.setup.fluid.bodies.empty());
  EXPECT_FALSE(scene.setup.solids[0].interface.has_value());
  EXPECT_EQ(scene.setup.solids[0].elastic.fitted_sides[2].kind, ElasticBoundary::displacement);
  EXPECT_NEAR(scene.setup.fluid.domain.high.x(), 1, 1e-12);
  EXPECT_NEAR(scene.setup.fluid.domain.low.y(), -1, 1e-12);
}

std::string refusal(const std::string& name, const Overrides& overrides) {
  try {
    scene_of(name, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SolidScene, RefusesWhatCannotBegin) {
  const std::string inverted =
      refusal("plane_waves", {"exact=none", "solids.0.initial={kind=\"formula\", displacement=[\"-1.5*x\", 0]}"});
  EXPECT_NE(inverted.find("solids.0 (block): initial: J = det(I + ∇u) is -0.5"), std::string::npos) << inverted;
  const std::string folded =
      refusal("deforming_diffuser", {"exact=none", "initial.kind=uniform", "initial.state=[1, 0, 0, 1]",
                                     "boundaries={}", "solids.0.wall=\"0.4*sin(2*pi*x)\""});
  EXPECT_NE(folded.find("is folded at t = 0"), std::string::npos) << folded;
  const std::string close = refusal("shock_deformable_sticks", {"grid.factor=4", "solids.1.position=[-0.4, 0]"});
  EXPECT_NE(close.find("solids.0 (stick_0) overlaps solids.1 (stick_1) at t = 0"), std::string::npos) << close;
  const std::string outside = refusal("shock_deformable_sticks", {"grid.factor=4", "solids.0.position=[-1.98, 0]"});
  EXPECT_NE(outside.find("reaches outside the domain"), std::string::npos) << outside;
}

}  // namespace
}  // namespace mortise
