#include "mortise/cases/driver/initial_check.hpp"

#include <cmath>
#include <sstream>

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

}  // namespace

template <int Dim>
void check_initial_state(const CaseDescription& description, const Simulation<Dim>& simulation) {
  const EulerSolver<Dim>& fluid = simulation.fluid();
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    const Pose<Dim> pose =
        grid.background() ? Pose<Dim>{} : simulation.bodies()[static_cast<std::size_t>(grid.body)].pose;
    for (int t = 0; t < grid.forest.local_count(); ++t)
      for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& cell) {
        const std::size_t k = grid.shape.at(cell);
        const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
        if (mask.cut() && mask.state[k] != CellState::active) return;
        const Point<Dim> x = fluid.cell_center(static_cast<int>(g), t, cell, pose);
        const Primitive<Dim> W = simulation.setup().initial(x, 0);
        if (!admissible(W.density) || !admissible(W.pressure)) refuse(description, x, W);
        for (const double u : W.velocity)
          if (!std::isfinite(u)) refuse(description, x, W);
      });
  }
}

template void check_initial_state<1>(const CaseDescription&, const Simulation<1>&);
template void check_initial_state<2>(const CaseDescription&, const Simulation<2>&);

}  // namespace mortise
