// Looking at an incompressible flow, and its state for continued runs.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mortise/coupler/reference_map/incompressible_solver.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Calls visit(value) for all that a continued run needs of a tile, in a fixed order.
template <class Block, class Visit>
void for_each_value(const TileShape<2>& shape, Block& velocity, Block& pressure, Block& correction, Visit&& visit) {
  const auto walk = [&](auto* values, int more) {
    for (int j = 0; j < shape.cells[1] + more; ++j)
      for (int i = 0; i < shape.cells[0] + more; ++i) visit(values[shape.at(i, j)]);
  };
  walk(velocity.component(0), 0);
  walk(velocity.component(1), 0);
  walk(pressure.component(0), 1);
  walk(correction.component(0), 0);
}

/// Bilinear between four neighbours, the lower left one at p; weights in [0, 1].
double bilinear(const double* p, int stride, double x, double y) {
  return (1 - y) * ((1 - x) * p[0] + x * p[1]) + y * ((1 - x) * p[stride] + x * p[stride + 1]);
}

}  // namespace

std::optional<FlowSample> IncompressibleSolver::sample(const Point<2>& place) const {
  const TileShape<2>& shape = flow_.shape();
  const Point<2> x = (place - grid().origin).cwiseQuotient(flow_.spacing());
  const Index<2> cell{static_cast<int>(std::floor(x[0])), static_cast<int>(std::floor(x[1]))};
  for (int t = 0; t < flow_.tiles(); ++t) {
    const Index<2> first = grid().first_cell(t);
    const Index<2> c{cell[0] - first[0], cell[1] - first[1]};
    if (c[0] < 0 || c[1] < 0 || c[0] >= shape.cells[0] || c[1] >= shape.cells[1]) continue;
    const double px = x[0] - cell[0], py = x[1] - cell[1];
    const int left = px < 0.5 ? c[0] - 1 : c[0], below = py < 0.5 ? c[1] - 1 : c[1];
    const double vx = px < 0.5 ? px + 0.5 : px - 0.5, vy = py < 0.5 ? py + 0.5 : py - 0.5;
    FlowSample found;
    for (int k = 0; k < 2; ++k)
      found.velocity[k] = bilinear(velocity_.tile(t).component(k) + shape.at(left, below), shape.stride, vx, vy);
    found.pressure = bilinear(pressure_.tile(t).component(0) + shape.at(c), shape.stride, px, py);
    return found;
  }
  return std::nullopt;
}

std::vector<double> IncompressibleSolver::state(int tile) const {
  std::vector<double> values;
  for_each_value(flow_.shape(), velocity_.tile(tile), pressure_.tile(tile), correction_.tile(tile),
                 [&](double value) { values.push_back(value); });
  return values;
}

void IncompressibleSolver::restore(double time, const std::vector<std::vector<double>>& states) {
  const auto nx = static_cast<std::size_t>(flow_.shape().cells[0]),
             ny = static_cast<std::size_t>(flow_.shape().cells[1]);
  const std::size_t expected = 3 * nx * ny + (nx + 1) * (ny + 1);
  bool fits = states.size() == static_cast<std::size_t>(flow_.tiles());
  for (const auto& values : states) fits = fits && values.size() == expected;
  if (!fits) throw InputError("the state to continue from is that of another grid of the flow");
  for (int t = 0; t < flow_.tiles(); ++t) {
    const double* next = states[static_cast<std::size_t>(t)].data();
    for_each_value(flow_.shape(), velocity_.tile(t), pressure_.tile(t), correction_.tile(t),
                   [&](double& value) { value = *next++; });
  }
  time_ = time;
  flow_.exchange_points(pressure_);
  flow_.exchange(correction_);
  flow_.fill_velocity(velocity_);
  measure_flow();
  if (!solids_) return;
  solids_->full_step(velocity_, time_, *fields_);
  complete_fields();
}

/// The largest |u| and |v| of all cells and the energy, whose sum does not depend on who owns which tiles.
void IncompressibleSolver::measure_flow() {
  std::vector<double> energies;
  largest_.setZero();
  for (int t = 0; t < flow_.tiles(); ++t) {
    const FlowMeasure sum = measure(projection_tile(t), velocity_.tile(t).component(0));
    largest_ = largest_.cwiseMax(sum.largest);
    energies.push_back(sum.energy);
  }
  const Communicator& comm = grid().forest.communicator();
  for (int d = 0; d < 2; ++d) largest_[d] = comm.max(largest_[d]);
  energies = comm.gather_all(energies);
  energy_ = std::accumulate(energies.begin(), energies.end(), 0.0);
}

}  // namespace mortise
