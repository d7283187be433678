#include "mortise/fluid/wall_areas.hpp"

namespace mortise {

std::vector<Point<2>> wall_areas(const GrownGrid& start, const GrownGrid& end) {
  const auto half_time = [&](int i) -> Point<2> {
    const Point<2> x = start.node(i, 0);
    return x + 0.5 * (end.node(i, 0) - x);
  };
  std::vector<Point<2>> areas;
  Point<2> here = half_time(0);
  for (int i = 0; i < start.along; ++i) {
    const Point<2> next = half_time(i + 1);
    areas.emplace_back(here[1] - next[1], next[0] - here[0]);
    here = next;
  }
  return areas;
}

}  // namespace mortise
