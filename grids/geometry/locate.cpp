// Where is X on the grid? On the 3 × 3 cell centres c_kl around a middle cell, with (u, v) the offset in cells,
//   x(u, v) = Σ_kl L_k(u) L_l(v) c_kl,   L_{−1} = u(u−1)/2, L_0 = 1 − u², L_1 = u(u+1)/2,
// is solved for (u, v) by Newton's method, in powers of u and v and relative to the middle centre. The middle is the cell
// whose centre is nearest to X, a choice that does not depend on where the search began, nor on which way round the
// grid is numbered. Third order in the spacing.
#include <array>
#include <cmath>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

namespace {

constexpr double converged = 1e-7;   // Newton step, cells: the error left is its square
constexpr double slack = 0.1;        // cells beyond the grid that still count as on it
constexpr double clamp_inside = 3;   // spacings inside the body that locate_clamped() accepts
constexpr double farthest = 2.5;     // cells: larger offsets are cut
constexpr int most_iterations = 30;
constexpr double early_move = 0.75;  // cells: beyond this offset the next cell's stencil is asked
constexpr int most_moves = 4;

/// Quadratic through three equally spaced values: q[0] + q[1] t + q[2] t², t = −1, 0, 1.
using Quadratic = std::array<Point<2>, 3>;

Quadratic quadratic(const Point<2>& before, const Point<2>& here, const Point<2>& after) {
  return {here, 0.5 * (after - before), 0.5 * (after + before) - here};
}
Point<2> value(const Quadratic& q, double t) { return q[0] + t * (q[1] + t * q[2]); }
Point<2> slope(const Quadratic& q, double t) { return q[1] + 2 * t * q[2]; }

/// x(u, v) − x(0, 0) = Σ_l v^l power[l](u).
struct Biquadratic {
  std::array<Quadratic, 3> power;

  Biquadratic(const BodyAtlas& atlas, const Index<2>& middle) {
    const Point<2> origin = atlas.center(middle[0], middle[1]);
    std::array<Quadratic, 3> row;
    for (std::size_t l = 0; l < 3; ++l) {
      const int j = middle[1] + static_cast<int>(l) - 1;
      row[l] = quadratic(atlas.center(middle[0] - 1, j) - origin, atlas.center(middle[0], j) - origin,
                         atlas.center(middle[0] + 1, j) - origin);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Quadratic across = quadratic(row[0][k], row[1][k], row[2][k]);
      for (std::size_t l = 0; l < 3; ++l) power[l][k] = across[l];
    }
  }
};

/// One Newton step towards x(offset) = target; zero where the map is singular.
Point<2> newton_step(const Biquadratic& map, const Point<2>& target, const Point<2>& offset) {
  const double u = offset[0], v = offset[1];
  const Quadratic in_v{value(map.power[0], u), value(map.power[1], u), value(map.power[2], u)};
  const Point<2> residual = target - value(in_v, v), along_v = slope(in_v, v);
  const Point<2> along_u = slope(map.power[0], u) + v * (slope(map.power[1], u) + v * slope(map.power[2], u));
  const double determinant = cross(along_u, along_v);
  if (determinant == 0) return Point<2>::Zero();
  return Point<2>(cross(residual, along_v), cross(along_u, residual)) / determinant;
}

int wrapped(int i, int period) { return i < 0 ? i + period : i >= period ? i - period : i; }

}  // namespace

int BodyAtlas::nearest_cell(const Point<2>& X) const {
  const double x = (X.x() - table_low_.x()) * table_per_length_ + 0.5,
               y = (X.y() - table_low_.y()) * table_per_length_ + 0.5;
  if (!(x >= 0 && y >= 0 && x < table_size_[0] && y < table_size_[1])) return -1;
  return cell_table_[static_cast<std::size_t>(static_cast<int>(y) * table_size_[0] + static_cast<int>(x))];
}

/// The cell whose centre is nearest to X, found downhill from a cell close to it.
Index<2> BodyAtlas::nearest_center(const Point<2>& X, Index<2> cell) const {
  double best = (X - center(cell[0], cell[1])).squaredNorm();
  for (bool moved = true; moved;) {
    moved = false;
    const Index<2> from = cell;
    for (int j = std::max(from[1] - 1, 0); j <= std::min(from[1] + 1, grid_.layers - 1); ++j)
      for (int i = from[0] - 1; i <= from[0] + 1; ++i) {
        const double distance2 = (X - center(i, j)).squaredNorm();
        if (distance2 >= best) continue;
        best = distance2;
        cell = {wrapped(i, grid_.along), j};
        moved = true;
      }
  }
  return cell;
}

bool BodyAtlas::locate(const Point<2>& X, StencilPoint& where) const {
  const int close = nearest_cell(X);
  if (close < 0) return false;
  const Index<2> nearest = nearest_center(X, {close % grid_.along, close / grid_.along});
  where.center = {nearest[0], std::clamp(nearest[1], 1, grid_.layers - 2)};
  where.offset = {0, nearest[1] - where.center[1]};
  for (int moves = 0; moves < most_moves; ++moves) {
    if (!solve(X, where)) return false;
    if (std::abs(where.offset[0]) <= early_move) break;
    const int shift = where.offset[0] > 0 ? 1 : -1;  // cells askew: the nearest centre is not that of the cell X is in
    where.center[0] = wrapped(where.center[0] + shift, grid_.along);
    where.offset[0] -= shift;
  }
  const double eta = where.center[1] + where.offset[1];
  return std::abs(where.offset[0]) <= 1 && eta >= -0.5 - slack && eta <= grid_.layers - 0.5 + slack;
}

/// Newton's method on the stencil where.center, from where.offset on.
bool BodyAtlas::solve(const Point<2>& X, StencilPoint& where) const {
  const Biquadratic map(*this, where.center);
  const Point<2> target = X - center(where.center[0], where.center[1]);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Point<2> step = newton_step(map, target, where.offset);
    where.offset += step;
    if (!where.offset.allFinite()) return false;
    where.offset = where.offset.cwiseMax(-farthest).cwiseMin(farthest);
    if (step.squaredNorm() < converged * converged) return true;
  }
  return false;
}

bool BodyAtlas::locate_clamped(const Point<2>& X, StencilPoint& where) const {
  if (locate(X, where)) return true;
  const int cell = nearest_cell(X);
  if (cell < 0 || distance(X) < -clamp_inside * grid_.spacing || distance(X) > 0.5 * grid_.spacing) return false;
  where.center = {cell % grid_.along, 1};
  where.offset = {0, -1};
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const int i = where.center[0];
    const Quadratic row = quadratic(center(i - 1, 0), center(i, 0), center(i + 1, 0));
    const double u = where.offset[0];
    const Point<2> residual = X - value(row, u), along = slope(row, u);
    const double curvature = std::max(0.5 * along.squaredNorm(), along.squaredNorm() - 2 * residual.dot(row[2]));
    const double step = std::clamp(residual.dot(along) / curvature, -1.0, 1.0);
    where.offset[0] += step;
    if (std::abs(step) < converged && std::abs(where.offset[0]) < 0.5 + slack) return true;
    const int shift = std::abs(where.offset[0]) > 0.5 + slack ? static_cast<int>(std::lround(where.offset[0])) : 0;
    where.center[0] = wrapped(i + shift, grid_.along);
    where.offset[0] -= shift;
  }
  where.offset[0] = std::clamp(where.offset[0], -0.5, 0.5);
  return true;
}

Point<2> BodyAtlas::logical(const StencilPoint& where) const {
  const double xi = where.center[0] + where.offset[0], period = grid_.along;
  return {xi < -0.5 ? xi + period : xi >= period - 0.5 ? xi - period : xi, where.center[1] + where.offset[1]};
}

bool BodyAtlas::locate(const Point<2>& X, Point<2>& logical_point) const {
  StencilPoint where;
  if (!locate(X, where)) return false;
  logical_point = logical(where);
  return true;
}

bool BodyAtlas::locate_clamped(const Point<2>& X, Point<2>& logical_point) const {
  StencilPoint where;
  if (!locate_clamped(X, where)) return false;
  logical_point = logical(where);
  return true;
}

}  // namespace mortise
