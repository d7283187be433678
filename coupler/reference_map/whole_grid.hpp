// A field of the tiles as one array that every rank holds, row by row: for methods that couple all points at once.
#pragma once

#include <vector>

#include "mortise/coupler/reference_map/pressure_solver.hpp"

namespace mortise {

class WholeGrid {
 public:
  /// Points are the cells of the grid or its nodes: cells + 1 of them along a direction that is not periodic.
  /// Collective.
  WholeGrid(const ComponentGrid<2>& grid, PressurePlace place);

  Index<2> points() const { return points_; }
  std::size_t count() const { return static_cast<std::size_t>(points_[0]) * static_cast<std::size_t>(points_[1]); }

  /// whole[j · stride + i] = value at point (i, j), on every rank. Collective.
  void gather(const Field<2>& field, double* whole, std::ptrdiff_t stride);
  /// The inverse, on this rank's tiles; all ghosts that lie on the grid (periodic directions wrap) are filled as well.
  void scatter(const double* whole, std::ptrdiff_t stride, Field<2>& field) const;

 private:
  void place_tile(const Index<2>& tile, const double* values, std::ptrdiff_t from, double* whole,
                  std::ptrdiff_t stride) const;
  int width(int tile, std::size_t d) const;  // points a tile owns along d

  const ComponentGrid<2>* grid_;
  PressurePlace place_;
  Index<2> points_;
  std::vector<Index<2>> coordinates_;  // of all tiles in their global order
  std::vector<double> mine_;           // with several ranks: points of this rank's tiles
};

}  // namespace mortise
