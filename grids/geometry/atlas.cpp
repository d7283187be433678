// The tables of a BodyAtlas: a uniform lattice of step h/2 over all points closer than width + 6h, aligned with the
// origin of the body's frame, so that the tables of a symmetric outline are symmetric.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

namespace {

constexpr double table_step = 0.5;     // spacings
constexpr double reach_margin = 6;     // spacings beyond the grid's width
constexpr double nearest_inside = 4;   // spacings inside the body, and
constexpr double nearest_outside = 3;  // beyond the grid's width, to which nearest cells are tabulated
constexpr double boundless = 1e100;    // half the side of an inward body's reach
constexpr int block_size = 16;         // table steps, 8 spacings

}  // namespace

BodyAtlas::BodyAtlas(const Outline& outline, GrownGrid grid, bool inward)
    : grid_(std::move(grid)), inward_(inward), bounds_(outline.bounds()) {
  width_ = std::numeric_limits<double>::infinity();
  for (int i = 0; i < grid_.along; ++i)
    width_ = std::min(width_, std::abs(outline.tree().nearest(grid_.node(i, grid_.layers)).distance));
  place_tables();
  fill_centers();
  fill_distances(outline);
  fill_nearest_cells();
  fill_blocks();
}

void BodyAtlas::place_tables() {
  const double step = table_step * grid_.spacing;
  const Box<2> wanted = bounds_.grown((inward_ ? 0 : width_) + reach_margin * grid_.spacing);
  for (int d = 0; d < 2; ++d) {
    const double first = std::floor(wanted.low[d] / step), last = std::ceil(wanted.high[d] / step);
    vicinity_.low[d] = first * step;
    vicinity_.high[d] = last * step;
    table_size_[static_cast<std::size_t>(d)] = static_cast<int>(last - first) + 1;
  }
  table_low_ = vicinity_.low;
  table_per_length_ = 1 / step;
  reach_ = inward_ ? Box<2>{Point<2>::Constant(-boundless), Point<2>::Constant(boundless)} : vicinity_;
}

void BodyAtlas::fill_centers() {
  centers_.reserve(static_cast<std::size_t>(grid_.layers * (grid_.along + 2)));
  for (int j = 0; j < grid_.layers; ++j)
    for (int i = -1; i <= grid_.along; ++i)
      centers_.push_back(
          0.25 * ((grid_.node(i, j) + grid_.node(i + 1, j)) + (grid_.node(i, j + 1) + grid_.node(i + 1, j + 1))));
}

void BodyAtlas::fill_distances(const Outline& outline) {
  const double step = table_step * grid_.spacing;
  distance_table_.reserve(static_cast<std::size_t>(table_size_[0]) * static_cast<std::size_t>(table_size_[1]));
  for (int j = 0; j < table_size_[1]; ++j) {
    double bound = StripTree::unbounded;
    for (int i = 0; i < table_size_[0]; ++i) {
      const Point<2> x = table_low_ + step * Point<2>(i, j);
      const double distance = outline.tree().nearest(x, bound).distance;
      distance_table_.push_back(inward_ ? -distance : distance);
      bound = std::abs(distance) + 1.0001 * step;
    }
  }
}

// Each cell claims the table nodes around it that are nearer to it than to the cells before; then the claims spread
// from node to node over the rest of the strip along the grid.
void BodyAtlas::fill_nearest_cells() {
  const double step = table_step * grid_.spacing;
  const int columns = table_size_[0], rows = table_size_[1];
  cell_table_.assign(distance_table_.size(), -1);
  std::vector<double> claimed(distance_table_.size(), std::numeric_limits<double>::infinity());
  std::vector<int> spreading;
  const auto claim = [&](int cell, int i, int j) {
    if (i < 0 || j < 0 || i >= columns || j >= rows) return;
    const int at = j * columns + i;
    const auto k = static_cast<std::size_t>(at);
    const double d = distance_table_[k];
    if (d < -nearest_inside * grid_.spacing || d > width_ + nearest_outside * grid_.spacing) return;
    const Point<2> x = table_low_ + step * Point<2>(i, j);
    const double squared = (x - center(cell % grid_.along, cell / grid_.along)).squaredNorm();
    if (!(squared < claimed[k])) return;
    claimed[k] = squared;
    cell_table_[k] = cell;
    spreading.push_back(at);
  };
  for (int cell = 0; cell < grid_.along * grid_.layers; ++cell) {
    const Point<2> at = (center(cell % grid_.along, cell / grid_.along) - table_low_) * table_per_length_;
    const int i = static_cast<int>(at.x()), j = static_cast<int>(at.y());
    for (int dj = 0; dj < 2; ++dj)
      for (int di = 0; di < 2; ++di) claim(cell, i + di, j + dj);
  }
  for (std::size_t k = 0; k < spreading.size(); ++k) {
    const int i = spreading[k] % columns, j = spreading[k] / columns;
    const int cell = cell_table_[static_cast<std::size_t>(spreading[k])];
    claim(cell, i - 1, j);
    claim(cell, i + 1, j);
    claim(cell, i, j - 1);
    claim(cell, i, j + 1);
  }
}

void BodyAtlas::fill_blocks() {
  for (std::size_t d = 0; d < 2; ++d) block_count_[d] = (table_size_[d] - 1) / block_size + 1;
  blocks_.assign(static_cast<std::size_t>(block_count_[0]) * static_cast<std::size_t>(block_count_[1]), 0);
  for (const Point<2>& x : centers_) {
    const Point<2> at = (x - table_low_) * (table_per_length_ / block_size);
    blocks_[static_cast<std::size_t>(static_cast<int>(at.y()) * block_count_[0] + static_cast<int>(at.x()))] = 1;
  }
}

bool BodyAtlas::near_grid(const Box<2>& box) const {
  Index<2> low, high;
  const Box<2> wide = box.grown(grid_.spacing);
  for (int d = 0; d < 2; ++d) {
    const auto k = static_cast<std::size_t>(d);
    const auto block_at = [&](double x) {
      const double block = std::floor((x - table_low_[d]) * (table_per_length_ / block_size));
      return static_cast<int>(std::clamp<double>(block, -1, block_count_[k]));
    };
    low[k] = std::max(block_at(wide.low[d]), 0);
    high[k] = std::min(block_at(wide.high[d]), block_count_[k] - 1);
  }
  for (int j = low[1]; j <= high[1]; ++j)
    for (int i = low[0]; i <= high[0]; ++i)
      if (blocks_[static_cast<std::size_t>(j * block_count_[0] + i)]) return true;
  return false;
}

double BodyAtlas::distance_bound(const Point<2>& X) const {
  const double distance = (X - X.cwiseMax(bounds_.low).cwiseMin(bounds_.high)).norm();
  return inward_ ? -distance : distance;
}

}  // namespace mortise
