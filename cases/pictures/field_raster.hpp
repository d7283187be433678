// Cell data of overlapping grids on the pixels of a picture, without seams: every grid that holds data at a pixel
// contributes, weighted by how deep the pixel lies among its active cells, so that the sum changes smoothly from grid
// to grid.
#pragma once

#include <vector>

#include "mortise/cases/pictures/axes.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

class FieldRaster {
 public:
  explicit FieldRaster(const Axes& axes);

  /// Adds a grid. values: one per cell, NaN where there is none (holes at least). priority: weight of this grid in
  /// the interior of an overlap. beyond: into holes, too, where there are values. Work: pixels
  /// covered by the grid, plus its cells.
  void add(const GridSnapshot& grid, const std::vector<double>& values, double priority, bool beyond = false);

  /// Value at pixel (x, y), counted from the top left of the axes; NaN where no grid has data.
  double at(int x, int y) const;

 private:
  struct Sampler;
  void add_cartesian(const Sampler& sampler, const Point<2>& origin, const Point<2>& spacing, bool beyond);
  void add_mapped(const Sampler& sampler);
  void add_cell(const Sampler& sampler, int i, int j);

  Axes axes_;
  int width_, height_;
  std::vector<float> sum_, weight_;  // per pixel: Σ w q, Σ w
};

}  // namespace mortise
