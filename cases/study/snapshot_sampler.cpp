#include "mortise/cases/study/snapshot_sampler.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mortise/grids/geometry/strip_tree.hpp"

namespace mortise {
namespace {

Point<2> node(const GridSnapshot& grid, int i, int j) {
  const std::size_t n = grid.node(i, j);
  return {grid.x[n], grid.y[n]};
}

/// Centroid of the quadrilateral, from its two triangles.
Point<2> centroid(const GridSnapshot& grid, int i, int j) {
  const Point<2> a = node(grid, i, j), b = node(grid, i + 1, j), c = node(grid, i + 1, j + 1), d = node(grid, i, j + 1);
  const double first = cross(b - a, c - a), second = cross(c - a, d - a), all = first + second;
  if (!(std::abs(all) > 0)) return 0.25 * (a + b + c + d);
  return a + ((b - a + c - a) * first + (c - a + d - a) * second) / (3 * all);
}

std::int64_t bucket(std::int64_t i, std::int64_t j) { return i * 4294967291LL + j; }
std::int64_t bucket_of(const Point<2>& x, double width) {
  return bucket(static_cast<std::int64_t>(std::floor(x.x() / width)),
                static_cast<std::int64_t>(std::floor(x.y() / width)));
}

/// The first of three neighbouring cells around i, inside the grid.
int window(int i, int cells) { return std::clamp(i - 1, 0, std::max(0, cells - 3)); }

}  // namespace

double cell_area(const GridSnapshot& grid, int i, int j) {
  return 0.5 *
         std::abs(cross(node(grid, i + 1, j + 1) - node(grid, i, j), node(grid, i, j + 1) - node(grid, i + 1, j)));
}

std::vector<Point<2>> cell_places(const GridSnapshot& grid) {
  std::vector<Point<2>> places;
  const std::vector<double>*X = grid.field("reference_x"), *Y = grid.field("reference_y");
  for (int j = 0; j < grid.cells[1]; ++j)
    for (int i = 0; i < grid.cells[0]; ++i) {
      const std::size_t c = grid.cell(i, j);
      places.push_back(grid.solid && X && Y ? Point<2>((*X)[c], (*Y)[c]) : centroid(grid, i, j));
      if (grid.dimension == 1) places.back().y() = 0;
    }
  return places;
}

SnapshotSampler::SnapshotSampler(const Snapshot& snapshot, bool solid, std::vector<std::string> fields) {
  for (const GridSnapshot& grid : snapshot.grids) {
    if (grid.solid != solid) continue;
    Grid entry{&grid, cell_places(grid), {}, 0, {}};
    for (const std::string& name : fields) entry.fields.push_back(grid.field(name));
    if (std::count(entry.fields.begin(), entry.fields.end(), nullptr) > 0) continue;
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int i = 0; i < grid.cells[0]; ++i)
        if (grid.mask[grid.cell(i, j)] == mask_active)
          entry.width = std::max(entry.width, (node(grid, i + 1, j + 1) - node(grid, i, j)).norm());
    if (!(entry.width > 0)) continue;
    for (std::size_t c = 0; c < entry.places.size(); ++c)
      if (grid.mask[c] == mask_active) entry.buckets[bucket_of(entry.places[c], entry.width)].push_back(c);
    grids_.push_back(std::move(entry));
  }
}

std::optional<std::vector<double>> SnapshotSampler::operator()(const Point<2>& x, const std::string& grid) const {
  const Grid* best = nullptr;
  std::size_t cell = 0;
  double least = 0;
  for (const Grid& candidate : grids_) {
    const auto found = nearest(candidate, x);
    if (!found) continue;
    // in cells of that grid; half a diagonal is inside
    double distance = (candidate.places[*found] - x).norm() / candidate.width;
    if (candidate.grid->name == grid && distance < 0.55) distance = -1;
    if (!best || distance < least) best = &candidate, cell = *found, least = distance;
  }
  if (!best) return std::nullopt;
  return fitted(*best, cell, x);
}

std::optional<std::size_t> SnapshotSampler::nearest(const Grid& grid, const Point<2>& x) const {
  const auto column = static_cast<std::int64_t>(std::floor(x.x() / grid.width));
  const auto row = static_cast<std::int64_t>(std::floor(x.y() / grid.width));
  std::optional<std::size_t> best;
  double least = grid.width;  // one cell
  for (std::int64_t j = row - 1; j <= row + 1; ++j)
    for (std::int64_t i = column - 1; i <= column + 1; ++i) {
      const auto found = grid.buckets.find(bucket(i, j));
      if (found == grid.buckets.end()) continue;
      for (const std::size_t c : found->second)
        if (const double distance = (grid.places[c] - x).norm(); distance < least) best = c, least = distance;
    }
  return best;
}

/// W(x) = W_c + g·d + ½ d·H d, weighted least squares over the neighbours.
std::vector<double> SnapshotSampler::fitted(const Grid& entry, std::size_t cell, const Point<2>& x) const {
  const GridSnapshot& grid = *entry.grid;
  const int n = grid.cells[0], i = static_cast<int>(cell % static_cast<std::size_t>(n)),
            j = static_cast<int>(cell / static_cast<std::size_t>(n));
  const Point<2> origin = entry.places[cell], d = (x - origin) / entry.width;
  const bool line = grid.dimension == 1 || grid.cells[1] < 3;
  std::vector<std::size_t> neighbours;
  for (int b = line ? j : window(j, grid.cells[1]), last_b = line ? j : b + 2; b <= last_b; ++b)
    for (int a = window(i, n), last_a = std::min(n - 1, a + 2); a <= last_a; ++a)
      if (const std::size_t c = grid.cell(a, b); c != cell && grid.mask[c] != mask_hole) neighbours.push_back(c);
  const int unknowns = line ? (neighbours.size() >= 2 ? 2 : 1) : (neighbours.size() >= 6 ? 5 : 2);
  const auto terms = [&](const Point<2>& r) {
    Eigen::RowVectorXd row(unknowns);
    if (line)
      row = Eigen::RowVector2d(r.x(), r.x() * r.x()).head(unknowns);
    else if (unknowns == 2)
      row << r.x(), r.y();
    else
      row << r.x(), r.y(), r.x() * r.x(), r.x() * r.y(), r.y() * r.y();
    return row;
  };
  Eigen::MatrixXd A(neighbours.size(), unknowns), B(neighbours.size(), entry.fields.size());
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const Point<2> r = (entry.places[neighbours[k]] - origin) / entry.width;
    const double weight = 1 / std::max(r.squaredNorm(), 1e-12);
    A.row(static_cast<Eigen::Index>(k)) = weight * terms(r);
    for (std::size_t f = 0; f < entry.fields.size(); ++f)
      B(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(f)) =
          weight * ((*entry.fields[f])[neighbours[k]] - (*entry.fields[f])[cell]);
  }
  Eigen::RowVectorXd change = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(entry.fields.size()));
  if (!neighbours.empty()) change = terms(d) * A.completeOrthogonalDecomposition().solve(B);
  std::vector<double> values;
  for (std::size_t f = 0; f < entry.fields.size(); ++f) {
    const std::vector<double>& field = *entry.fields[f];
    double low = field[cell], high = low;
    for (const std::size_t c : neighbours) low = std::min(low, field[c]), high = std::max(high, field[c]);
    values.push_back(std::clamp(field[cell] + change[static_cast<Eigen::Index>(f)], low, high));
  }
  return values;
}

}  // namespace mortise
