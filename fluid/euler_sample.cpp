// Values at arbitrary points: from the overlap, or from the meshes of a scene without one.
#include <limits>

#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/euler_solver.hpp"
#include "mortise/grids/geometry/find_cell.hpp"

namespace mortise {

/// Bilinear between the centres of the cell and its neighbours on the side of the point; constant towards a boundary.
template <int Dim>
typename EulerSolver<Dim>::Values EulerSolver<Dim>::value_in(int g, int t, const Index<Dim>& cell, const Point<Dim>& within) const {
  const auto of_grid = static_cast<std::size_t>(g);
  const ComponentGrid<Dim>& grid = grids_[of_grid];
  const Index<Dim> first = grid.first_cell(t);
  Values sum{};
  for (unsigned corner = 0; corner < 1u << Dim; ++corner) {
    Index<Dim> from = cell;
    double weight = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      const double away = within[static_cast<int>(d)] - 0.5;
      const bool neighbor = corner >> d & 1u;
      weight *= neighbor ? std::fabs(away) : 1 - std::fabs(away);
      const int shifted = first[d] + cell[d] + (away < 0 ? -1 : 1);
      if (neighbor && (grid.periodic[d] || (shifted >= 0 && shifted < grid.cells[d]))) from[d] += away < 0 ? -1 : 1;
    }
    const Primitive<Dim> W = to_primitive(get<Dim>(now_[of_grid].tile(t), grid.shape.at(from)), setup_.gas.gamma);
    sum[0] += weight * W.density;
    for (std::size_t d = 0; d < Dim; ++d) sum[1 + d] += weight * W.velocity[d];
    sum[Dim + 1] += weight * W.pressure;
  }
  return sum;
}

template <int Dim>
std::vector<typename EulerSolver<Dim>::Values> EulerSolver<Dim>::sample(std::span<const Point<Dim>> points) const {
  if (overlap_) {
    const double gamma = setup_.gas.gamma;
    return overlap_->template sample<components>(now_, points, [gamma](const double* U, double* W) { decode<Dim>(U, W, gamma); });
  }
  std::vector<std::size_t> held;  // points in cells of this rank
  std::vector<Values> mine;       // values there
  if constexpr (Dim == 2)
    for (std::size_t p = 0; p < points.size(); ++p)
      for (std::size_t g = 0; g < grids_.size(); ++g) {
        const auto body = static_cast<std::size_t>(grids_[g].body);
        CellPoint at;
        if (!find_cell(*meshes_[body], Frame<2>(poses_[body]).to_body(points[p]), at)) continue;
        const Index<2>& cells = grids_[g].shape.cells;
        const Neighbor tile = grids_[g].forest.find({at.cell[0] / cells[0], at.cell[1] / cells[1]});
        if (tile.rank == comm_.rank()) {
          held.push_back(p);
          mine.push_back(value_in(static_cast<int>(g), tile.local, {at.cell[0] % cells[0], at.cell[1] % cells[1]}, at.within));
        }
        break;
      }
  Values nowhere;
  nowhere.fill(std::numeric_limits<double>::quiet_NaN());
  std::vector<Values> values(points.size(), nowhere);
  const std::vector<std::size_t> places = comm_.gather_all(held);
  const std::vector<Values> found = comm_.gather_all(mine);
  for (std::size_t k = 0; k < places.size(); ++k) values[places[k]] = found[k];
  return values;
}

template class EulerSolver<1>;
template class EulerSolver<2>;

}  // namespace mortise
