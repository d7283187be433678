// A BodyAtlas from the grid alone. Every cell, bilinear between its nodes,
//   x = a + ξ (b − a) + η (d − a) + ξη (a − b + c − d),
// writes (j + η) thickness, and itself, to the table nodes in it; so do the cells of a few layers by which the grid is
// continued on either side, the innermost first, so that the layers nearer to the curve have the last word. What is left
// is inside or outside the curve by parity along the rows of the table.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

namespace {

constexpr int layers_inside = 4;   // the grid is continued into the body,
constexpr int layers_outside = 2;  // and beyond its outermost layer

using Quad = std::array<Point<2>, 4>;  // a, b, c, d, counter-clockwise

bool folded(const Quad& q) {
  for (std::size_t k = 0; k < 4; ++k)
    if (!(cross(q[(k + 1) % 4] - q[k], q[(k + 3) % 4] - q[k]) > 0)) return true;
  return false;
}

/// Whether x is in a quadrilateral, edges included. Without branches: which edge fails first cannot be predicted.
bool holds(const Quad& q, const Point<2>& x) {
  constexpr double on_edge = -1e-9;
  const double south = cross(q[1] - q[0], x - q[0]), east = cross(q[2] - q[1], x - q[1]);
  const double north = cross(q[3] - q[2], x - q[2]), west = cross(q[0] - q[3], x - q[3]);
  return std::min(std::min(south, east), std::min(north, west)) >= on_edge;
}

/// η of a point of a quadrilateral, by Newton's method from its middle; one step is exact for parallelograms.
double height_in(const Quad& q, const Point<2>& x) {
  const Point<2> along = q[1] - q[0], across = q[3] - q[0], twist = q[2] - q[3] - along, target = x - q[0];
  double xi = 0.5, eta = 0.5;
  for (int iteration = 0; iteration < 2; ++iteration) {
    const Point<2> d_xi = along + eta * twist, d_eta = across + xi * twist;
    const Point<2> residual = target - xi * d_xi - eta * across;
    const double inverse = 1 / cross(d_xi, d_eta);
    xi += cross(residual, d_eta) * inverse;
    eta += cross(d_xi, residual) * inverse;
  }
  return std::clamp(eta, 0.0, 1.0);
}

}  // namespace

BodyAtlas::BodyAtlas(GrownGrid grid, bool inward) : grid_(std::move(grid)), inward_(inward) {
  width_ = grid_.layers * grid_.thickness;
  for (int i = 0; i < grid_.along; ++i) bounds_.include(grid_.node(i, 0));
  place_tables();
  fill_centers();
  rasterize();
  fill_blocks();
}

void BodyAtlas::rasterize() {
  const std::size_t count = static_cast<std::size_t>(table_size_[0]) * static_cast<std::size_t>(table_size_[1]);
  const double deep = -(layers_inside + 1) * grid_.thickness, beyond = width_ + layers_outside * grid_.thickness;
  distance_table_.assign(count, inward_ ? deep : beyond);
  cell_table_.assign(count, -1);
  std::vector<Point<2>> below = table_row(-layers_inside), above;
  for (int j = -layers_inside; j < grid_.layers + layers_outside; ++j) {
    above = table_row(j + 1);
    for (std::size_t i = 0; i + 1 < below.size(); ++i) {
      const Quad quad{below[i], below[i + 1], above[i + 1], above[i]};
      const bool continued = j < 0 || j >= grid_.layers;
      if (!continued || !folded(quad)) rasterize_cell(static_cast<int>(i), j, quad);
    }
    below.swap(above);
  }
  if (inward_)
    fill_interior(deep, beyond);
  else
    fill_interior(beyond, deep);
}

/// Nodes (0 … along, j) in steps of the table from its corner.
std::vector<Point<2>> BodyAtlas::table_row(int j) const {
  std::vector<Point<2>> row;
  row.reserve(static_cast<std::size_t>(grid_.along) + 1);
  for (int i = 0; i <= grid_.along; ++i) row.push_back((grid_.node(i, j) - table_low_) * table_per_length_);
  return row;
}

void BodyAtlas::rasterize_cell(int i, int j, const std::array<Point<2>, 4>& quad) {
  const Point<2> low = quad[0].cwiseMin(quad[1]).cwiseMin(quad[2].cwiseMin(quad[3])).array() - 1e-9;
  const Point<2> high = quad[0].cwiseMax(quad[1]).cwiseMax(quad[2].cwiseMax(quad[3])).array() + 1e-9;
  const int first_column = std::max(static_cast<int>(std::ceil(low.x())), 0),
            first_row = std::max(static_cast<int>(std::ceil(low.y())), 0),
            last_column = std::min(static_cast<int>(std::floor(high.x())), table_size_[0] - 1),
            last_row = std::min(static_cast<int>(std::floor(high.y())), table_size_[1] - 1);
  const int cell = std::clamp(j, 0, grid_.layers - 1) * grid_.along + i;
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      const Point<2> x(column, row);
      if (!holds(quad, x)) continue;
      const auto k = static_cast<std::size_t>(row * table_size_[0] + column);
      distance_table_[k] = (j + height_in(quad, x)) * grid_.thickness;
      cell_table_[k] = cell;
    }
}

/// Writes `to` to the table nodes inside the curve that no cell has written to, which hold `from`.
void BodyAtlas::fill_interior(double from, double to) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(table_size_[1]));  // of each row, in columns
  const std::vector<Point<2>> curve = table_row(0);
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    Point<2> a = curve[i], b = curve[i + 1];
    if (a.y() > b.y()) std::swap(a, b);
    for (int row = static_cast<int>(std::ceil(a.y())); row < b.y(); ++row)
      crossings[static_cast<std::size_t>(row)].push_back(a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  for (std::size_t row = 0; row < crossings.size(); ++row) {
    std::vector<double>& x = crossings[row];
    std::sort(x.begin(), x.end());
    double* values = distance_table_.data() + row * static_cast<std::size_t>(table_size_[0]);
    for (std::size_t k = 0; k + 1 < x.size(); k += 2)
      std::replace(values + static_cast<int>(std::ceil(x[k])), values + static_cast<int>(std::ceil(x[k + 1])), from, to);
  }
}

}  // namespace mortise
