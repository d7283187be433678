// Largest rate at which waves cross cells, Σ_d (|u_d − w_d| + c)/h_d, of a given state.
#include "mortise/fluid/node_rows.hpp"
#include "mortise/fluid/rows.hpp"

namespace mortise {
namespace {

/// Largest over the counting cells of a tile of rate_of(U, i, j, counts), U the vector of cells from (i, j) on.
template <int Dim, class RateOf>
StepResult largest_rate(const CartesianTile<Dim>& tile, double* weight, RateOf rate_of) {
  const TileShape<Dim>& shape = *tile.shape;
  const int nx = shape.cells[0], ny = Dim == 2 ? shape.cells[Dim - 1] : 1;
  Pack rate{};
  for (int j = 0; j < ny; ++j) {
    rows::fill_weights(weight, nx, tile.active ? tile.active + shape.at(0, j) : nullptr);
    for (int i = 0; i < nx; i += simd_width) {
      const auto U = rows::valid_beyond<Dim>(nx - i, rows::load_conserved<Dim>(tile.now + shape.at(i, j), shape.plane));
      rate = max(rate, rate_of(U, i, j, load(weight + i) > 0));
    }
  }
  return rows::result_of(rate);
}

}  // namespace

StepResult wave_rate(const MovingLineTile& tile, const StepOptions& options) {
  const RowWorkspace work(tile.line.shape->cells[0], 1);
  return largest_rate(tile.line, work.row(0), [&](const Conserved<1, Pack>& U, int, int, PackMask counts) {
    return rows::line_rate(U, tile.velocity, 1 / tile.line.spacing[0], options.gamma, counts);
  });
}

template <>
StepResult wave_rate<1>(const CartesianTile<1>& tile, const StepOptions& options) {
  return wave_rate(MovingLineTile{tile, 0, {}, {}}, options);
}

template <>
StepResult wave_rate<2>(const CartesianTile<2>& tile, const StepOptions& options) {
  const RowWorkspace work(tile.shape->cells[0], 1);
  const std::array<double, 2> inverse_spacing = {1 / tile.spacing[0], 1 / tile.spacing[1]};
  return largest_rate(tile, work.row(0), [&](const Conserved<2, Pack>& U, int, int, PackMask counts) {
    return rows::cartesian_rate(U, inverse_spacing, options.gamma, counts);
  });
}

StepResult wave_rate(const CurvilinearTile& tile, const StepOptions& options) {
  const int nx = tile.shape->cells[0];
  const RowWorkspace work(nx, 2);
  std::fill(work.row(1) + row_start, work.row(1) + nx + 2, 0.0);
  const rows::NodeRows nodes(tile, work.row(1));
  const CartesianTile<2> cells{tile.shape, tile.now, nullptr, {}, tile.active};
  return largest_rate(cells, work.row(0), [&](const Conserved<2, Pack>& U, int i, int j, PackMask counts) {
    const MovingCell<Pack> cell = nodes.cell(i, j);
    const MovingEdge<Pack> west = cell.west(), east = cell.east(), south = cell.south(), north = cell.north();
    const Pack volume = select(lanes_below(nx - i), cell.area(0), broadcast(1.0));
    return rows::curvilinear_rate(U, west + east, south + north,
                                  (length(west) + length(east)) + (length(south) + length(north)), 1.0 / volume,
                                  options.gamma, counts);
  });
}

}  // namespace mortise
