#include "mortise/coupler/reference_map/incompressible_setup.hpp"

#include <array>
#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

void require(bool holds, const std::string& sentence) {
  if (!holds) throw InputError(sentence);
}

constexpr std::array<const char*, 4> side_names{"west", "east", "south", "north"};

void check_grid(const IncompressibleSetup& setup) {
  for (std::size_t d = 0; d < 2; ++d) {
    const auto e = static_cast<Eigen::Index>(d);
    require(setup.domain.high[e] > setup.domain.low[e], "the domain of the flow has no extent");
    require(setup.tile[d] >= 4 && setup.tile[d] % 2 == 0,
            "tiles of an incompressible flow are even and at least 4 cells wide, not " + std::to_string(setup.tile[d]));
    require(setup.cells[d] > 0 && setup.cells[d] % setup.tile[d] == 0,
            std::to_string(setup.cells[d]) + " cells are no whole number of tiles of " + std::to_string(setup.tile[d]));
  }
}

void check_numbers(const IncompressibleSetup& setup) {
  const auto in_unit = [](double x) { return x > 0 && x <= 1; };
  require(setup.density > 0 && std::isfinite(setup.density), "the density of the fluid must be positive");
  require(setup.viscosity >= 0 && std::isfinite(setup.viscosity), "the viscosity of the fluid must not be negative");
  require(in_unit(setup.cfl), "cfl must lie in (0, 1], not " + std::to_string(setup.cfl));
  require(in_unit(setup.viscous_fraction),
          "viscous_fraction must lie in (0, 1], not " + std::to_string(setup.viscous_fraction));
  require(setup.tolerance > 0 && setup.tolerance < 1, "the tolerance of the pressure solver must lie in (0, 1)");
}

/// Flux into the domain through an inflow side, by the midpoint rule on its cells, and the flux of its magnitude.
Point<2> flux_in(const IncompressibleSetup& setup, std::size_t side) {
  const auto n = static_cast<Eigen::Index>(side / 2), t = 1 - n;
  const int cells = setup.cells[static_cast<std::size_t>(t)];
  const double h = (setup.domain.high[t] - setup.domain.low[t]) / cells;
  Point<2> sum(0, 0), place;
  place[n] = side % 2 == 0 ? setup.domain.low[n] : setup.domain.high[n];
  for (int k = 0; k < cells; ++k) {
    place[t] = setup.domain.low[t] + (k + 0.5) * h;
    const double v = setup.sides[side].velocity(place)[n] * (side % 2 == 0 ? h : -h);
    sum += Point<2>(v, std::abs(v));
  }
  return sum;
}

void check_sides(const IncompressibleSetup& setup) {
  bool outlet = false;
  Point<2> in(0, 0);
  for (std::size_t s = 0; s < 4; ++s) {
    const FlowSide& side = setup.sides[s];
    require((side.kind == SideKind::periodic) == (setup.sides[s ^ 1].kind == SideKind::periodic),
            std::string("the sides ") + side_names[s] + " and " + side_names[s ^ 1] +
                " are periodic together or not at all");
    outlet = outlet || side.kind == SideKind::outflow;
    if (side.kind != SideKind::inflow) continue;
    require(bool(side.velocity), std::string("the inflow at the ") + side_names[s] + " side has no velocity");
    in += flux_in(setup, s);
  }
  require(outlet || std::abs(in[0]) <= 1e-12 * in[1], "more fluid flows in than out, and there is no outflow side");
}

}  // namespace

void check(const IncompressibleSetup& setup) {
  check_grid(setup);
  check_numbers(setup);
  check_sides(setup);
}

}  // namespace mortise
