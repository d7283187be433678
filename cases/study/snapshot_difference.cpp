#include "mortise/cases/study/snapshot_difference.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/study/snapshot_sampler.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using Values = std::vector<double>;

/// What is compared, and how the errors of single cells come from the fields of both.
struct Compared {
  bool solid;
  std::vector<std::string> fields;
  std::vector<std::string> names;
  Values (*errors)(const Values& coarse, const Values& fine);
};

Values fluid_errors(const Values& a, const Values& b) {
  Values errors;
  for (std::size_t f = 0; f < a.size(); ++f) errors.push_back(a[f] - b[f]);
  errors.push_back(a.back() / a.front() - b.back() / b.front());
  return errors;
}

Values solid_errors(const Values& a, const Values& b) {
  return {std::hypot(a[0] - b[0], a[1] - b[1]), std::hypot(a[2] - b[2], a[3] - b[3]),
          std::sqrt(std::pow(a[4] - b[4], 2) + 2 * std::pow(a[5] - b[5], 2) + std::pow(a[6] - b[6], 2))};
}

const Compared all_compared[] = {
    {false,
     {"density", "velocity_x", "pressure"},
     {"fluid.density", "fluid.velocity_x", "fluid.pressure", "fluid.temperature"},
     fluid_errors},
    {false,
     {"density", "velocity_x", "velocity_y", "pressure"},
     {"fluid.density", "fluid.velocity_x", "fluid.velocity_y", "fluid.pressure", "fluid.temperature"},
     fluid_errors},
    {true,
     {"displacement_x", "displacement_y", "velocity_x", "velocity_y", "stress_xx", "stress_xy", "stress_yy"},
     {"solid.displacement", "solid.velocity", "solid.stress"},
     solid_errors}};

/// Of a plane snapshot the kind with both velocities, of a line the other one.
bool applies(const Compared& kind, const Snapshot& snapshot) {
  const auto grid = std::find_if(snapshot.grids.begin(), snapshot.grids.end(),
                                 [&](const GridSnapshot& g) { return g.solid == kind.solid && g.cell_count() > 0; });
  if (grid == snapshot.grids.end()) return false;
  const bool plane = grid->field("velocity_y") != nullptr;
  const bool wants_plane = std::count(kind.fields.begin(), kind.fields.end(), "velocity_y") > 0;
  return plane == wants_plane && std::all_of(kind.fields.begin(), kind.fields.end(),
                                             [&](const std::string& name) { return grid->field(name) != nullptr; });
}

class Sums {
 public:
  explicit Sums(std::size_t count) : norms_(count) {}
  void add(const Values& errors, double area) {
    area_ += area;
    for (std::size_t q = 0; q < errors.size(); ++q) {
      const double e = std::abs(errors[q]);
      norms_[q].l1 += e * area;
      norms_[q].l2 += e * e * area;
      norms_[q].max = std::max(norms_[q].max, e);
    }
  }
  ErrorNorms operator[](std::size_t q) const {
    return {norms_[q].l1 / area_, std::sqrt(norms_[q].l2 / area_), norms_[q].max};
  }
  bool empty() const { return !(area_ > 0); }

 private:
  std::vector<ErrorNorms> norms_;
  double area_ = 0;
};

/// The middles of the four quarters of a cell, about its place: where blocks of four fine cells have theirs.
std::array<Point<2>, 4> quarters(const GridSnapshot& grid, int i, int j, const Point<2>& place) {
  const auto node = [&](int a, int b) {
    const std::size_t n = grid.node(a, b);
    return Point<2>(grid.x[n], grid.y[n]);
  };
  const Point<2> a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
  const Point<2> middle = 0.25 * (a + b + c + d);
  std::array<Point<2>, 4> points{a, b, c, d};
  for (Point<2>& p : points) {
    p = place + 0.5 * (p - middle);
    if (grid.dimension == 1) p.y() = 0;
  }
  return points;
}

void compare(const Compared& kind, const GridSnapshot& grid, const SnapshotSampler& fine, Sums& sums) {
  const std::vector<Point<2>> places = cell_places(grid);
  std::vector<const Values*> fields;
  for (const std::string& name : kind.fields) fields.push_back(grid.field(name));
  for (int j = 0; j < grid.cells[1]; ++j)
    for (int i = 0; i < grid.cells[0]; ++i) {
      const std::size_t cell = grid.cell(i, j);
      if (grid.mask[cell] != mask_active) continue;
      Values mean(fields.size(), 0.0), here;
      bool covered = true;
      for (const Point<2>& x : quarters(grid, i, j, places[cell])) {
        const auto values = fine(x, grid.name);
        if (!(covered = values.has_value())) break;
        for (std::size_t f = 0; f < fields.size(); ++f) mean[f] += 0.25 * (*values)[f];
      }
      if (!covered) continue;
      for (const Values* field : fields) here.push_back((*field)[cell]);
      sums.add(kind.errors(here, mean), cell_area(grid, i, j));
    }
}

}  // namespace

std::map<std::string, ErrorNorms> snapshot_difference(const Snapshot& coarse, const Snapshot& fine) {
  std::map<std::string, ErrorNorms> norms;
  for (const Compared& kind : all_compared) {
    if (!applies(kind, coarse) || !applies(kind, fine)) continue;
    const SnapshotSampler sampler(fine, kind.solid, kind.fields);
    Sums sums(kind.names.size());
    for (const GridSnapshot& grid : coarse.grids)
      if (grid.solid == kind.solid) compare(kind, grid, sampler, sums);
    if (sums.empty()) continue;
    for (std::size_t q = 0; q < kind.names.size(); ++q) norms[kind.names[q]] = sums[q];
  }
  if (norms.empty()) throw InputError("the two solutions have no field in common to compare");
  return norms;
}

}  // namespace mortise
