// |∇ρ| on a mapped grid x(ξ, η): with differences δ of cell-centre values along ξ and η,
//   ∇ρ = J⁻ᵀ (δ_ξ ρ, δ_η ρ),  J = [δ_ξ x  δ_η x],
// central (order 2) where both neighbours hold data, one-sided (order 1) otherwise; exact for linear ρ on any mapping.
#include "mortise/cases/pictures/picture_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<Point<2>> cell_centers(const GridSnapshot& grid) {
  std::vector<Point<2>> centers;
  centers.reserve(grid.cell_count());
  for (int j = 0; j < grid.cells[1]; ++j)
    for (int i = 0; i < grid.cells[0]; ++i) {
      const std::size_t a = grid.node(i, j), b = grid.node(i, j + 1);
      centers.emplace_back(0.25 * (grid.x[a] + grid.x[a + 1] + grid.x[b] + grid.x[b + 1]),
                           0.25 * (grid.y[a] + grid.y[a + 1] + grid.y[b] + grid.y[b + 1]));
    }
  return centers;
}

/// |∇q| from the differences of position and value along one or both directions of the grid.
double gradient_norm(const Point<2>& along0, double rise0, const Point<2>& along1, double rise1) {
  const double area = along0.x() * along1.y() - along0.y() * along1.x();
  if (area != 0)
    return std::hypot(rise0 * along1.y() - rise1 * along0.y(), rise1 * along0.x() - rise0 * along1.x()) /
           std::fabs(area);
  const double length = std::max(along0.norm(), along1.norm());  // a direction without neighbours
  return length > 0 ? std::max(std::fabs(rise0), std::fabs(rise1)) / length : 0;
}

class Gradient {
 public:
  Gradient(const GridSnapshot& grid, const std::vector<double>& values)
      : grid_(grid), values_(values), centers_(cell_centers(grid)), closed_(closed_along(grid)) {}

  double norm(int i, int j) const {
    const auto [a0, b0] = pair(i, j, {1, 0});
    const auto [a1, b1] = pair(i, j, {0, 1});
    return gradient_norm(centers_[b0] - centers_[a0], values_[b0] - values_[a0], centers_[b1] - centers_[a1],
                         values_[b1] - values_[a1]);
  }

 private:
  /// The cells between which the difference at (i, j) is taken.
  std::array<std::size_t, 2> pair(int i, int j, const Index<2>& step) const {
    const std::size_t here = grid_.cell(i, j);
    return {usable(i - step[0], j - step[1]).value_or(here), usable(i + step[0], j + step[1]).value_or(here)};
  }
  std::optional<std::size_t> usable(int i, int j) const {
    if (closed_) i = (i + grid_.cells[0]) % grid_.cells[0];
    if (i < 0 || i >= grid_.cells[0] || j < 0 || j >= grid_.cells[1]) return {};
    const std::size_t cell = grid_.cell(i, j);
    if (grid_.mask[cell] == mask_hole) return {};
    return cell;
  }

  const GridSnapshot& grid_;
  const std::vector<double>& values_;
  std::vector<Point<2>> centers_;
  bool closed_;
};

std::vector<double> schlieren(const GridSnapshot& grid, const std::vector<double>& density) {
  const Gradient gradient(grid, density);
  std::vector<double> values(grid.cell_count(), nothing);
  for (int j = 0; j < grid.cells[1]; ++j)
    for (int i = 0; i < grid.cells[0]; ++i)
      if (grid.mask[grid.cell(i, j)] != mask_hole) values[grid.cell(i, j)] = gradient.norm(i, j);
  return values;
}

/// The values of one grid; nothing when it has no such field.
std::optional<std::vector<double>> values_on(const GridSnapshot& grid, const std::string& field) {
  if (field == "velocity") {
    const auto *u = grid.field("velocity_x"), *v = grid.field("velocity_y");
    if (!u) return {};
    std::vector<double> speed(*u);
    for (std::size_t c = 0; c < speed.size(); ++c) speed[c] = std::hypot((*u)[c], v ? (*v)[c] : 0.0);
    return speed;
  }
  const auto* source = grid.field(field == "schlieren" ? "density" : field == "stress" ? "von_mises" : field);
  if (!source) return {};
  return field == "schlieren" ? schlieren(grid, *source) : *source;
}

[[noreturn]] void refuse(const Snapshot& snapshot, const std::string& field) {
  std::vector<std::string> known{"schlieren", "velocity", "stress", "grids"};
  for (const GridSnapshot& grid : snapshot.grids)
    for (const auto& [name, values] : grid.fields)
      if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
  const std::string guess = nearest(field, known);
  throw InputError("there is nothing to draw for the picture \"" + field + "\"" +
                   (guess.empty() || guess == field ? "" : ", did you mean \"" + guess + "\"?") +
                   " (known: " + joined(known) + ")");
}

}  // namespace

bool has_solids(const Snapshot& snapshot) {
  return std::any_of(snapshot.grids.begin(), snapshot.grids.end(), [](const GridSnapshot& grid) { return grid.solid; });
}

bool closed_along(const GridSnapshot& grid) {
  const int n = grid.cells[0];
  if (n < 3) return false;
  for (int j = 0; j <= grid.cells[1]; ++j) {
    const std::size_t a = grid.node(0, j), b = grid.node(n, j);
    const double cell = std::hypot(grid.x[a + 1] - grid.x[a], grid.y[a + 1] - grid.y[a]);
    if (std::hypot(grid.x[a] - grid.x[b], grid.y[a] - grid.y[b]) > 1e-6 * cell) return false;
  }
  return true;
}

PictureValues picture_values(const Snapshot& snapshot, const std::string& field) {
  PictureValues all;
  bool any = false;
  for (const GridSnapshot& grid : snapshot.grids) {
    std::optional<std::vector<double>> values = values_on(grid, field);
    any = any || values;
    all.push_back(values ? std::move(*values) : std::vector<double>(grid.cell_count(), nothing));
    for (std::size_t c = 0; c < grid.cell_count(); ++c)
      if (grid.mask[c] == mask_hole) all.back()[c] = nothing;
  }
  if (!any) refuse(snapshot, field);
  return all;
}

std::array<double, 2> value_range(const Snapshot& snapshot, const PictureValues& values, const std::string& field) {
  std::vector<double> active;
  for (std::size_t k = 0; k < values.size(); ++k)
    for (std::size_t c = 0; c < values[k].size(); ++c)
      if (snapshot.grids[k].mask[c] == mask_active && std::isfinite(values[k][c])) active.push_back(values[k][c]);
  if (active.empty()) return {0, 1};
  if (field == "schlieren") {
    const auto rank = active.begin() + static_cast<std::ptrdiff_t>(0.997 * static_cast<double>(active.size() - 1));
    std::nth_element(active.begin(), rank, active.end());
    return {0, *rank};
  }
  const auto [low, high] = std::minmax_element(active.begin(), active.end());
  const bool flat =
      *high - *low < 1e-13 * std::max(std::fabs(*low), std::fabs(*high));  // round-off is not worth colours
  return {*low, flat ? *low : *high};
}

}  // namespace mortise
