#include "mortise/cases/input/case_checks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "unit/cases/input/scratch_case.hpp"

namespace mortise {
namespace {

using test::error_of, test::line_case, test::plane_case, test::read_text, test::with;

TEST(CaseChecks, GasBehindAShock) {
  const auto behind = gas_behind_shock({1, 0, 0, 1}, 2, {1, 0}, 1.4, 0);
  EXPECT_NEAR(behind[0], 2.666666666666667, 1e-14);
  EXPECT_NEAR(behind[1], 1.479019945774904, 1e-14);
  EXPECT_NEAR(behind[3], 4.5, 1e-14);
}

/// Mass, momentum and energy flux through the front are continuous, in its frame, for every direction and stiffened
/// gas.
RC_GTEST_PROP(CaseChecks, ShockConservesFluxes, ()) {
  const double mach = 1 + *rc::gen::inRange(1, 500) / 100.0, angle = *rc::gen::inRange(0, 628) / 100.0;
  const double gamma = 1 + *rc::gen::inRange(1, 30) / 10.0, p_inf = *rc::gen::inRange(0, 3);
  const std::array<double, 4> ahead = {1.3, 0.4, -0.7, 0.9};
  const std::array<double, 2> n = {std::cos(angle), std::sin(angle)};
  const auto behind = gas_behind_shock(ahead, mach, n, gamma, p_inf);
  const double front = ahead[1] * n[0] + ahead[2] * n[1] + mach * std::sqrt(gamma * (ahead[3] + p_inf) / ahead[0]);
  const auto fluxes = [&](const std::array<double, 4>& w) {
    const double u = w[1] * n[0] + w[2] * n[1] - front, h = gamma / (gamma - 1) * (w[3] + p_inf) / w[0] + 0.5 * u * u;
    return std::array<double, 3>{w[0] * u, w[0] * u * u + w[3], w[0] * u * h};
  };
  const auto left = fluxes(behind), right = fluxes(ahead);
  for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(std::abs(left[k] - right[k]) <= 1e-11 * (1 + std::abs(right[k])));
  RC_ASSERT(std::abs((behind[1] - ahead[1]) * n[1] - (behind[2] - ahead[2]) * n[0]) < 1e-12);
}

TEST(CaseChecks, Grid) {
  EXPECT_EQ(error_of(plane_case, {"grid.high=[1, -2]"}),
            "--set grid.high=[1, -2]: grid.high must be greater than grid.low along y, not -2 against -1");
  EXPECT_EQ(error_of(plane_case, {"grid.factor=0.1"}),
            "--set grid.factor=0.1: grid.factor = 0.1 gives fewer than 4 cells along x: it must be at least 0.2");
  EXPECT_EQ(error_of(plane_case, {"grid.tile=[32, 31]"}),
            "--set grid.tile=[32, 31]: grid.tile must be even, not 31 along y");
  EXPECT_EQ(read_text(line_case, {"grid.tile=64"}).tile[0], 64);
}

TEST(CaseChecks, Boundaries) {
  EXPECT_EQ(
      error_of(plane_case, {"boundaries.left=periodic"}),
      "--set boundaries.left=periodic: boundaries.left and boundaries.right must be periodic both or neither, not "
      "\"periodic\" and \"outflow\"");
  EXPECT_EQ(
      error_of(plane_case, {"boundaries.top=exact"}),
      "--set boundaries.top=exact: boundaries.top = \"exact\" needs an exact solution: the key \"exact\" is missing");
  EXPECT_EQ(error_of(line_case, {"boundaries.top=wall"}),
            "--set boundaries.top=wall: boundaries.top is not there in 1D");
  const std::string riemann = with(line_case, "kind = \"uniform\"\nstate = [1, 0, 1]",
                                   "kind = \"riemann\"\nleft = [1, 0, 1]\nright = [2, 0, 2]");
  EXPECT_EQ(error_of(riemann + "[boundaries]\nleft = \"inflow\"\n"),
            "scratch.toml:16:1: the key \"boundaries.inflow\" is missing: the state of the gas at inflow sides");
}

TEST(CaseChecks, InflowFollowsTheInitialState) {
  EXPECT_FALSE(read_text(plane_case).has_inflow);
  const CaseDescription uniform = read_text(plane_case, {"boundaries.left=inflow"});
  EXPECT_TRUE(uniform.has_inflow);
  EXPECT_EQ(uniform.inflow, uniform.initial.state);
  const std::string shock = with(plane_case, "kind = \"uniform\"\nstate", "kind = \"shock\"\nmach = 2\nahead");
  EXPECT_NEAR(read_text(shock, {"boundaries.left=inflow"}).inflow[3], 4.5, 1e-14);
  EXPECT_EQ(read_text(shock, {"boundaries.left=inflow", "boundaries.inflow=[1, 2, 3, 4]"}).inflow[3], 4);
}

TEST(CaseChecks, Regions) {
  const std::string regions =
      with(plane_case, "kind = \"uniform\"\nstate = [1, 0, 0, 1]\n", "kind = \"regions\"\n") +
      "[[initial.regions]]\nwhere = \"x < 0\"\ndensity = 1\nvelocity = [\"y\", 0]\npressure = \"1 + x^2\"\n"
      "[[initial.regions]]\ndensity = 2\nvelocity = [0, 0]\npressure = 1\n";
  const CaseDescription c = read_text(regions);
  ASSERT_EQ(c.initial.regions.size(), 2u);
  EXPECT_EQ(c.initial.regions[0].velocity_x, "y");
  EXPECT_EQ(c.initial.regions[0].velocity_y, "0");
  EXPECT_EQ(c.initial.regions[0].pressure, "1 + x^2");
  EXPECT_EQ(
      error_of(regions, {"initial.regions.1.where=y"}),
      "--set initial.regions.1.where=y: initial.regions.1.where is not allowed: the last region is everywhere else");
  EXPECT_EQ(
      error_of(with(regions, "where = \"x < 0\"\n", "")),
      "scratch.toml:16:1: the key \"initial.regions.0.where\" is missing: only the last region is everywhere else");
  EXPECT_EQ(error_of(regions, {"initial.regions.1.density=-2"}),
            "--set initial.regions.1.density=-2: initial.regions.1.density = -2 is not allowed: it must be > 0");
  EXPECT_EQ(error_of(with(regions, "density = 2\n", ""))
                .rfind("scratch.toml:21:1: the key \"initial.regions.1.density\" is missing", 0),
            0u);
}

TEST(CaseChecks, Vortex) {
  EXPECT_EQ(error_of(line_case, {"initial.kind=vortex"}),
            "--set initial.kind=vortex: initial.kind = \"vortex\" is not there in 1D");
  const std::string vortex = with(plane_case, "kind = \"uniform\"\nstate = [1, 0, 0, 1]\n", "kind = \"vortex\"\n");
  EXPECT_EQ(error_of(vortex, {"initial.strength=5"}), "");
  EXPECT_EQ(error_of(vortex, {"initial.strength=12"})
                .rfind("--set initial.strength=12: initial.strength = 12 is too strong", 0),
            0u);
}

TEST(CaseChecks, ExactSolutionsNeedTheirScene) {
  EXPECT_EQ(error_of(plane_case, {"exact=vortex"}),
            "--set exact=vortex: exact = \"vortex\" needs initial.kind = vortex, not uniform");
  EXPECT_EQ(error_of(plane_case, {"exact=rigid_piston"}),
            "--set exact=rigid_piston: exact = \"rigid_piston\" needs dimension = 1");
  EXPECT_EQ(error_of(plane_case, {"exact=uniform"}), "");
  EXPECT_EQ(read_text(plane_case, {"exact=none"}).exact, "");
  EXPECT_EQ(error_of(plane_case, {"exact=vortx"})
                .rfind("--set exact=vortx: exact = \"vortx\" is not known, did you mean \"vortex\"?", 0),
            0u);
}

TEST(CaseChecks, Schemes) {
  const std::string no_bodies = plane_case.substr(0, plane_case.find("[[bodies]]"));
  EXPECT_EQ(read_text(no_bodies).scheme, "none");
  EXPECT_EQ(read_text(plane_case).scheme, "rigid");
  EXPECT_EQ(error_of(plane_case, {"scheme=rigit"}),
            "--set scheme=rigit: scheme = \"rigit\" is not known, did you mean \"rigid\"? (allowed: none, rigid, "
            "traditional, projection, traditional-subiterated, anti-traditional, reference-map)");
  EXPECT_EQ(error_of(plane_case, {"scheme=projection"}),
            "--set scheme=projection: scheme = \"projection\" needs an elastic solid in gas and the case has none: use "
            "rigid or traditional");
  EXPECT_EQ(error_of(plane_case, {"scheme=none"}),
            "--set scheme=none: scheme = \"none\" cannot move bodies: use rigid or traditional");
  EXPECT_EQ(error_of(no_bodies, {"scheme=rigid"}),
            "--set scheme=rigid: scheme = \"rigid\" needs bodies and the case has none: use none, or omit the scheme");
}

TEST(CaseChecks, NamesAndPlaces) {
  EXPECT_EQ(read_text(plane_case).bodies[0].name, "circle_0");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.name=a/b"}),
            "--set bodies.0.name=a/b: bodies.0.name = \"a/b\" is not allowed: use letters, digits, _ and -");
  EXPECT_EQ(error_of(plane_case, {"bodies.0.position=[3, 0]"}),
            "--set bodies.0.position=[3, 0]: bodies.0.position is outside the domain");
  const std::string probes = plane_case + "[[probes]]\nposition = [0.5, 0.5]\n[[probes]]\nposition = [0.5, 0.75]\n";
  EXPECT_EQ(read_text(probes).probes[1].name, "probe_1");
  EXPECT_EQ(error_of(probes, {"probes.1.name=probe_0"}),
            "--set probes.1.name=probe_0: probes.1.name = \"probe_0\" is the name of another one, too");
  EXPECT_NE(error_of(probes, {"probes.1.position.0=1.5"}).find("probes.1.position is outside the domain"),
            std::string::npos);
}

}  // namespace
}  // namespace mortise
