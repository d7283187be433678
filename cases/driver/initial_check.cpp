#include "mortise/cases/driver/initial_check.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mortise/cases/driver/local_cells.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

bool admissible(double value) { return value > 0 && std::isfinite(value); }

template <int Dim>
[[noreturn]] void refuse(const CaseDescription& description, const Point<Dim>& x, const Primitive<Dim>& W) {
  std::ostringstream text;
  text << description.path << ": initial: density " << W.density << " and pressure " << W.pressure - description.p_inf
       << " at (" << x[0];
  if constexpr (Dim == 2) text << ", " << x[1];
  text << ") are not allowed: density must be > 0 and pressure > " << 0 - description.p_inf
       << " everywhere in the gas at t = 0";
  throw InputError(text.str());
}

/// What formulas of the case file make of the solids.
void check_solid(const CaseDescription& description, const ElasticSolver& solid, const ElasticFunction& initial) {
  for (int g = 0; g < static_cast<int>(solid.grids().size()); ++g) {
    const ComponentGrid<2>& grid = solid.grids()[static_cast<std::size_t>(g)];
    for_each_local_cell<2>(grid, [&](int t, const Index<2>& c, std::size_t, std::size_t cell) {
      if (state_of(grid.masks[static_cast<std::size_t>(t)], cell) != CellState::active) return;
      const Point<2> X = solid.cell_center(g, t, c);
      const ElasticState state = initial(X, 0);
      if (std::all_of(state.begin(), state.end(), [](double value) { return std::isfinite(value); })) return;
      std::ostringstream text;
      text << description.path << ": the initial state of the solid \"" << solid.setup().name << "\" is not finite at ("
           << X.x() << ", " << X.y() << ")";
      throw InputError(text.str());
    });
  }
}

}  // namespace

template <int Dim>
void check_initial_state(const CaseDescription& description, const Simulation<Dim>& simulation) {
  const EulerSolver<Dim>& fluid = simulation.fluid();
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    for_each_local_cell<Dim>(grid, [&](int t, const Index<Dim>& c, std::size_t, std::size_t cell) {
      if (state_of(grid.masks[static_cast<std::size_t>(t)], cell) != CellState::active) return;
      const Point<Dim> x = fluid.cell_center(static_cast<int>(g), t, c);
      const Primitive<Dim> W = simulation.setup().initial(x, 0);
      if (!admissible(W.density) || !admissible(W.pressure)) refuse(description, x, W);
      for (const double u : W.velocity)
        if (!std::isfinite(u)) refuse(description, x, W);
    });
  }
  for (std::size_t k = 0; k < simulation.solids().size(); ++k)
    check_solid(description, *simulation.solids()[k], simulation.setup().solids[k].initial);
}

template void check_initial_state<1>(const CaseDescription&, const Simulation<1>&);
template void check_initial_state<2>(const CaseDescription&, const Simulation<2>&);

}  // namespace mortise
