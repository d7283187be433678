// Bodies and solids must start inside the domain, apart from each other, with room for their grids.
#include <cmath>
#include <sstream>

#include "mortise/cases/scene/scene.hpp"
#include "mortise/coupler/gaps.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {

namespace {

template <int Dim>
std::string sentence(double grid_factor, const std::vector<PlacedShape<Dim>>& shapes, const ContactPoint<Dim>& gap, double least_gap) {
  const PlacedShape<Dim>& shape = shapes[static_cast<std::size_t>(gap.a)];
  const std::string other = gap.b >= 0 ? shapes[static_cast<std::size_t>(gap.b)].label : "the edge of the domain";
  std::ostringstream text;
  text.precision(4);
  text << shape.place << ": " << shape.label << ' ';
  if (gap.gap > 0)
    text << "is too close to " << other;
  else
    text << (gap.b >= 0 ? "overlaps " + other : "reaches outside the domain");
  text << " at t = 0 near (" << gap.point[0];
  if constexpr (Dim == 2) text << ", " << gap.point[1];
  text << "): ";
  if (gap.gap > 0)
    text << "the gap is " << gap.gap << " and the grids need " << least_gap << ", so set grid.factor to at least "
         << std::ceil(10.5 * grid_factor * least_gap / gap.gap) / 10 << " or make the gap wider";
  else
    text << "move it by at least " << least_gap - gap.gap;
  return text.str();
}

}  // namespace

template <int Dim>
void check_clearance(double grid_factor, const EulerSetup<Dim>& fluid, const std::vector<PlacedShape<Dim>>& shapes, double least_gap) {
  std::vector<GapBody<Dim>> bodies;
  for (const PlacedShape<Dim>& shape : shapes) bodies.push_back({shape.atlas.get(), shape.outline.get(), shape.pose});
  std::array<bool, Dim> periodic{};
  for (std::size_t d = 0; d < Dim; ++d) periodic[d] = fluid.boundaries.kind[2 * d] == BoundaryKind::periodic;
  const std::vector<ContactPoint<Dim>> gaps = find_gaps<Dim>(bodies, fluid.domain, periodic, least_gap);
  if (!gaps.empty()) throw InputError(sentence(grid_factor, shapes, gaps.front(), least_gap));
}

template void check_clearance<1>(double, const EulerSetup<1>&, const std::vector<PlacedShape<1>>&, double);
template void check_clearance<2>(double, const EulerSetup<2>&, const std::vector<PlacedShape<2>>&, double);

}  // namespace mortise
