// A domain that repeats itself along some directions: bodies that cross such a side come in again at the other one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

template <int Dim>
class Periods {
 public:
  Periods() = default;
  Periods(const Box<Dim>& domain, const std::array<bool, Dim>& periodic) {
    for (int d = 0; d < Dim; ++d) {
      if (!periodic[static_cast<std::size_t>(d)]) continue;
      length_[d] = domain.high[d] - domain.low[d];
      any_ = true;
    }
  }

  /// The shifts by whole periods after which `box` meets `at`. A box without bounds has no images but itself.
  std::vector<Point<Dim>> images(const Box<Dim>& box, const Box<Dim>& at) const {
    std::vector<Point<Dim>> shifts;
    if (!any_ || (box.low.array() > box.high.array()).any()) {
      if (box.meets(at)) shifts.push_back(Point<Dim>::Zero());
      return shifts;
    }
    shifts.push_back(Point<Dim>::Zero());
    for (int d = 0; d < Dim; ++d) {
      if (!repeats(d, box)) continue;
      std::vector<Point<Dim>> all;
      const double first = std::ceil((at.low[d] - box.high[d]) / length_[d]),
                   last = std::floor((at.high[d] - box.low[d]) / length_[d]);
      for (double k = first; k <= last; ++k)
        for (Point<Dim> shift : shifts) {
          shift[d] = k * length_[d];
          all.push_back(shift);
        }
      shifts.swap(all);
    }
    std::erase_if(shifts, [&](const Point<Dim>& s) { return !Box<Dim>{box.low + s, box.high + s}.meets(at); });
    return shifts;
  }

  /// The shortest period; infinite if there is none.
  double shortest() const {
    double length = std::numeric_limits<double>::infinity();
    for (int d = 0; d < Dim; ++d)
      if (length_[d] > 0) length = std::min(length, length_[d]);
    return length;
  }

  /// x moved by whole periods to where it is nearest to the middle of `box`.
  Point<Dim> near(Point<Dim> x, const Box<Dim>& box) const {
    if (!any_) return x;
    for (int d = 0; d < Dim; ++d)
      if (repeats(d, box)) x[d] -= length_[d] * std::round((x[d] - 0.5 * (box.low[d] + box.high[d])) / length_[d]);
    return x;
  }

 private:
  bool repeats(int d, const Box<Dim>& box) const {
    return length_[d] > 0 && std::isfinite(box.high[d] - box.low[d]) && box.high[d] - box.low[d] < 1e200;
  }

  Point<Dim> length_ = Point<Dim>::Zero();  // of a period; 0: does not repeat
  bool any_ = false;
};

}  // namespace mortise
