#include "mortise/coupler/reference_map/whole_grid.hpp"

#include <algorithm>

namespace mortise {

WholeGrid::WholeGrid(const ComponentGrid<2>& grid, PressurePlace place)
    : grid_(&grid), place_(place), points_(grid.cells) {
  for (std::size_t d = 0; d < 2; ++d)
    if (place == PressurePlace::nodes && !grid.periodic[d]) ++points_[d];
  for (int t = 0; t < grid.forest.local_count(); ++t) coordinates_.push_back(grid.forest.coordinates(t));
  coordinates_ = grid.forest.communicator().gather_all(coordinates_);
}

int WholeGrid::width(int tile, std::size_t d) const {
  const int n = grid_->shape.cells[d];
  return std::min(points_[d] - tile * n, tile == grid_->forest.tiles()[d] - 1 ? n + 1 : n);
}

void WholeGrid::place_tile(const Index<2>& tile, const double* values, std::ptrdiff_t from, double* whole,
                           std::ptrdiff_t stride) const {
  const int wide = width(tile[0], 0), high = width(tile[1], 1);
  double* to = whole + tile[1] * grid_->shape.cells[1] * stride + tile[0] * grid_->shape.cells[0];
  for (int j = 0; j < high; ++j) std::copy_n(values + j * from, wide, to + j * stride);
}

void WholeGrid::gather(const Field<2>& field, double* whole, std::ptrdiff_t stride) {
  const TileShape<2>& shape = grid_->shape;
  const Communicator& comm = grid_->forest.communicator();
  if (comm.size() == 1) {
    for (int t = 0; t < field.tiles(); ++t)
      place_tile(coordinates_[static_cast<std::size_t>(t)], field.tile(t).component(0) + shape.at(0, 0), shape.stride,
                 whole, stride);
    return;
  }
  const int wide = shape.cells[0] + 1, high = shape.cells[1] + 1;
  mine_.clear();
  for (int t = 0; t < field.tiles(); ++t)
    for (int j = 0; j < high; ++j) {
      const double* row = field.tile(t).component(0) + shape.at(0, j);
      mine_.insert(mine_.end(), row, row + wide);
    }
  const std::vector<double> all = comm.gather_all(mine_);
  for (std::size_t k = 0; k < coordinates_.size(); ++k)
    place_tile(coordinates_[k], all.data() + k * static_cast<std::size_t>(wide * high), wide, whole, stride);
}

void WholeGrid::scatter(const double* whole, std::ptrdiff_t stride, Field<2>& field) const {
  const TileShape<2>& shape = grid_->shape;
  for (int t = 0; t < field.tiles(); ++t) {
    const Index<2> first = grid_->first_cell(t);
    double* const values = field.tile(t).component(0);
    // A point beyond the grid is wrapped where the grid is periodic; otherwise it is none.
    const auto wrapped = [&](int k, std::size_t d) {
      if (!grid_->periodic[d]) return k < points_[d] ? k : -1;
      return (k + points_[d]) % points_[d];
    };
    for (int j = -2; j < shape.cells[1] + 2; ++j) {
      const int row = wrapped(first[1] + j, 1);
      if (row < 0) continue;
      const double* const from = whole + row * stride;
      double* const to = values + shape.at(0, j);
      const int inner = std::min(shape.cells[0], points_[0] - first[0]);
      std::copy_n(from + first[0], inner, to);
      for (const int i : {-2, -1, shape.cells[0], shape.cells[0] + 1})
        if (const int column = wrapped(first[0] + i, 0); column >= 0) to[i] = from[column];
    }
  }
}

}  // namespace mortise
