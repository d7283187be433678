// Values of a snapshot's cell fields at any point.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// Where the cells of a grid are: of a fluid in space, of a solid in the reference frame (fields reference_x,
/// reference_y). A cell of a fluid is at the centroid of its four corners. Of lines and strips of them y is 0.
std::vector<Point<2>> cell_places(const GridSnapshot& grid);
double cell_area(const GridSnapshot& grid, int i, int j);

/// The grids of a snapshot that belong to fluids, or to solids.
class SnapshotSampler {
 public:
  /// Keeps a reference to the snapshot.
  SnapshotSampler(const Snapshot& snapshot, bool solid, std::vector<std::string> fields);

  /// The fields at x; nothing where no active cell is near. Cells of the grid named `grid` come first.
  std::optional<std::vector<double>> operator()(const Point<2>& x, const std::string& grid) const;

 private:
  struct Grid {
    const GridSnapshot* grid;
    std::vector<Point<2>> places;
    std::vector<const std::vector<double>*> fields;
    double width = 0;                                                    // of its largest cell
    std::unordered_map<std::int64_t, std::vector<std::size_t>> buckets;  // active cells by place
  };
  std::optional<std::size_t> nearest(const Grid& grid, const Point<2>& x) const;
  std::vector<double> fitted(const Grid& grid, std::size_t cell, const Point<2>& x) const;

  std::vector<Grid> grids_;
};

}  // namespace mortise
