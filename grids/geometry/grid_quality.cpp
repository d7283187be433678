#include <algorithm>
#include <array>
#include <cmath>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

GridQuality check(const GrownGrid& grid) {
  GridQuality worst{.min_corner_ratio = 1e300, .max_aspect = 0, .min_size = 1e300};
  for (int j = 0; j < grid.layers; ++j) {
    for (int i = 0; i < grid.along; ++i) {
      const std::array<Point<2>, 4> x{grid.node(i, j), grid.node(i + 1, j), grid.node(i + 1, j + 1),
                                      grid.node(i, j + 1)};
      std::array<double, 4> corner{}, side{};
      double smallest = 1e300, sum = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Point<2> next = x[(k + 1) % 4] - x[k], last = x[(k + 3) % 4] - x[k];
        corner[k] = cross(next, last) / 2;
        side[k] = next.norm();
        smallest = std::min(smallest, corner[k]);
        sum += corner[k];
      }
      const double area = sum / 2, along = side[0] + side[2], across = side[1] + side[3];
      const double ratio = sum > 0 ? 4 * smallest / sum : smallest < 0 ? -1 : 0;
      if (!(ratio >= worst.min_corner_ratio)) worst.min_corner_ratio = std::isfinite(ratio) ? ratio : -1;
      worst.max_aspect = std::max(worst.max_aspect, std::max(along, across) / std::min(along, across));
      worst.min_size = std::min(worst.min_size, area / *std::max_element(side.begin(), side.end()));
    }
  }
  return worst;
}

}  // namespace mortise
