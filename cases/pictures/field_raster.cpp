// q(pixel) = Σ_g w_g q_g / Σ_g w_g over the grids g, q_g bilinear between cell centres in the logical coordinates of
// the grid (order 2; cells without data are left out). w_g is bilinear too: 0.001 on fringe cells, then rising over
// three cells to the grid's priority; an edge of the grid itself (wall, domain boundary) does not lower it.
#include "mortise/cases/pictures/field_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mortise/cases/pictures/picture_values.hpp"

namespace mortise {
namespace {

constexpr double fringe_weight = 1e-3;
constexpr int ramp = 3;  // cells

/// Chessboard distance, at most `ramp`, from each cell to the nearest one that is not active.
std::vector<int> depth(const GridSnapshot& grid, bool closed) {
  std::vector<int> result(grid.cell_count());
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = grid.mask[c] == mask_active ? ramp : 0;
  const int n = grid.cells[0], m = grid.cells[1];
  for (int pass = 1; pass < ramp; ++pass) {
    const std::vector<int> before = result;
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        int& here = result[grid.cell(i, j)];
        for (int b = std::max(j - 1, 0); here > pass && b <= std::min(j + 1, m - 1); ++b)
          for (int a = i - 1; a <= i + 1; ++a) {
            if (!closed && (a < 0 || a >= n)) continue;
            if (before[grid.cell((a + n) % n, b)] < pass) here = pass;
          }
      }
  }
  return result;
}

/// Corner (0, 0) and spacing, if the nodes are those of a uniform Cartesian grid.
std::optional<std::array<Point<2>, 2>> cartesian(const GridSnapshot& grid) {
  const int n = grid.cells[0], m = grid.cells[1];
  const Point<2> origin(grid.x[0], grid.y[0]);
  const Point<2> spacing((grid.x[grid.node(n, 0)] - origin.x()) / n, (grid.y[grid.node(0, m)] - origin.y()) / m);
  if (!(spacing.x() > 0 && spacing.y() > 0)) return {};
  const double tolerance = 1e-6 * spacing.minCoeff();
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const std::size_t k = grid.node(i, j);
      if (std::fabs(grid.x[k] - origin.x() - i * spacing.x()) > tolerance ||
          std::fabs(grid.y[k] - origin.y() - j * spacing.y()) > tolerance)
        return {};
    }
  return std::array<Point<2>, 2>{origin, spacing};
}

/// (s, t) with p = bilinear(corners; s, t), by Newton; corners (0,0), (1,0), (1,1), (0,1).
Point<2> inverse_bilinear(const std::array<Point<2>, 4>& corner, const Point<2>& p) {
  const Point<2> e0 = corner[1] - corner[0], e1 = corner[3] - corner[0], twist = corner[2] - corner[1] - e1;
  Point<2> st(0.5, 0.5);
  for (int iteration = 0; iteration < 6; ++iteration) {
    const Point<2> residual = corner[0] + st.x() * e0 + st.y() * e1 + st.x() * st.y() * twist - p;
    const Point<2> ds = e0 + st.y() * twist, dt = e1 + st.x() * twist;
    const double area = ds.x() * dt.y() - ds.y() * dt.x();
    const Point<2> change((residual.x() * dt.y() - residual.y() * dt.x()) / area,
                          (ds.x() * residual.y() - ds.y() * residual.x()) / area);
    st -= change;
    if (change.cwiseAbs().maxCoeff() < 1e-9) break;
  }
  return st;
}

}  // namespace

struct FieldRaster::Sampler {
  Sampler(const GridSnapshot& grid_, const std::vector<double>& values_, double priority)
      : grid(grid_), values(values_), closed(closed_along(grid_)), weights(grid_.cell_count()) {
    const std::vector<int> deep = depth(grid, closed);
    for (std::size_t c = 0; c < weights.size(); ++c)
      weights[c] = deep[c] == 0 ? fringe_weight : priority * deep[c] / ramp;
  }

  /// Where along one direction: two neighbouring cells and the weight of the second.
  struct Line {
    int low, high;
    double share;
  };
  Line across(double logical, int direction) const {
    const int n = grid.cells[static_cast<std::size_t>(direction)];
    const double floor = std::floor(logical);
    const int low = static_cast<int>(floor);
    if (direction == 0 && closed) return {(low + n) % n, (low + 1) % n, logical - floor};
    return {std::clamp(low, 0, n - 1), std::clamp(low + 1, 0, n - 1), logical - floor};
  }

  /// Adds the values between the four cells to the sums of one pixel.
  void add(const Line& x, const Line& y, float& sum, float& weight) const {
    const std::size_t cell[4] = {grid.cell(x.low, y.low), grid.cell(x.high, y.low), grid.cell(x.low, y.high),
                                 grid.cell(x.high, y.high)};
    const double share[4] = {(1 - x.share) * (1 - y.share), x.share * (1 - y.share), (1 - x.share) * y.share,
                             x.share * y.share};
    double q = 0, w = 0, total = 0;
    for (int k = 0; k < 4; ++k) {
      if (!std::isfinite(values[cell[k]])) continue;
      q += share[k] * values[cell[k]];
      w += share[k] * weights[cell[k]];
      total += share[k];
    }
    if (total <= 0) return;
    sum += static_cast<float>(w * q / total);
    weight += static_cast<float>(w);
  }

  const GridSnapshot& grid;
  const std::vector<double>& values;
  bool closed;
  std::vector<double> weights;
};

FieldRaster::FieldRaster(const Axes& axes)
    : axes_(axes),
      width_(axes.x1 - axes.x0),
      height_(axes.y1 - axes.y0),
      sum_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0F),
      weight_(sum_) {}

double FieldRaster::at(int x, int y) const {
  const std::size_t k = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  return weight_[k] > 0 ? static_cast<double>(sum_[k] / weight_[k]) : std::numeric_limits<double>::quiet_NaN();
}

void FieldRaster::add(const GridSnapshot& grid, const std::vector<double>& values, double priority,
                      bool beyond) {
  const Sampler sampler(grid, values, priority);
  if (const auto uniform = cartesian(grid))
    add_cartesian(sampler, (*uniform)[0], (*uniform)[1], beyond);
  else
    add_mapped(sampler);
}

void FieldRaster::add_cartesian(const Sampler& sampler, const Point<2>& origin, const Point<2>& spacing,
                                bool beyond) {
  const GridSnapshot& grid = sampler.grid;
  struct Column {
    int x, cell;
    Sampler::Line line;
  };
  std::vector<Column> columns;  // the pixel columns that the grid covers
  for (int x = 0; x < width_; ++x) {
    const double logical = (axes_.window.low.x() + (x + 0.5) / axes_.scale_x() - origin.x()) / spacing.x();
    if (logical >= 0 && logical <= grid.cells[0])
      columns.push_back({x, std::min(static_cast<int>(logical), grid.cells[0] - 1), sampler.across(logical - 0.5, 0)});
  }
  for (int y = 0; y < height_; ++y) {
    const double logical = (axes_.window.high.y() - (y + 0.5) / axes_.scale_y() - origin.y()) / spacing.y();
    if (logical < 0 || logical > grid.cells[1]) continue;
    const int row = std::min(static_cast<int>(logical), grid.cells[1] - 1);
    const Sampler::Line line = sampler.across(logical - 0.5, 1);
    const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    for (const Column& column : columns) {
      if (!beyond && grid.mask[grid.cell(column.cell, row)] == mask_hole) continue;
      const std::size_t k = first + static_cast<std::size_t>(column.x);
      sampler.add(column.line, line, sum_[k], weight_[k]);
    }
  }
}

void FieldRaster::add_mapped(const Sampler& sampler) {
  for (int j = 0; j < sampler.grid.cells[1]; ++j)
    for (int i = 0; i < sampler.grid.cells[0]; ++i)
      if (sampler.grid.mask[sampler.grid.cell(i, j)] != mask_hole) add_cell(sampler, i, j);
}

void FieldRaster::add_cell(const Sampler& sampler, int i, int j) {
  const GridSnapshot& grid = sampler.grid;
  const std::size_t nodes[4] = {grid.node(i, j), grid.node(i + 1, j), grid.node(i + 1, j + 1), grid.node(i, j + 1)};
  std::array<Point<2>, 4> corner;
  Box<2> box;
  for (std::size_t k = 0; k < 4; ++k) {
    corner[k] = axes_.pixel({grid.x[nodes[k]], grid.y[nodes[k]]}) - Point<2>(axes_.x0, axes_.y0);
    box.include(corner[k]);
  }
  constexpr double margin = 1e-7;  // so that no pixel is lost between two cells
  const auto first = [](double low) {
    return std::max(0, static_cast<int>(std::ceil(std::clamp(low, -1.0, 1e6) - 0.5 - margin)));
  };
  const auto last = [](double high, int n) {
    return std::min(n - 1, static_cast<int>(std::floor(std::min<double>(high, n) - 0.5 + margin)));
  };
  for (int y = first(box.low.y()); y <= last(box.high.y(), height_); ++y)
    for (int x = first(box.low.x()); x <= last(box.high.x(), width_); ++x) {
      const Point<2> st = inverse_bilinear(corner, {x + 0.5, y + 0.5});
      if (!(st.minCoeff() >= -margin && st.maxCoeff() <= 1 + margin)) continue;
      const std::size_t k =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      sampler.add(sampler.across(i + st.x() - 0.5, 0), sampler.across(j + st.y() - 0.5, 1), sum_[k], weight_[k]);
    }
}

}  // namespace mortise
