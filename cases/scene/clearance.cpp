// Bodies must start inside the domain, apart from each other, with room for their grids.
#include <sstream>

#include "mortise/cases/scene/scene.hpp"
#include "mortise/coupler/gaps.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {

template <int Dim>
void check_clearance(const SimulationSetup<Dim>& setup, double least_gap) {
  std::vector<GapBody<Dim>> shapes;
  for (std::size_t b = 0; b < setup.bodies.size(); ++b)
    shapes.push_back({setup.fluid.bodies[b].shape.atlas.get(), setup.bodies[b].outline.get(), setup.bodies[b].body.pose});
  std::array<bool, Dim> periodic{};
  for (std::size_t d = 0; d < Dim; ++d) periodic[d] = setup.fluid.boundaries.kind[2 * d] == BoundaryKind::periodic;
  for (const ContactPoint<Dim>& gap : find_gaps<Dim>(shapes, setup.fluid.domain, periodic, least_gap)) {
    std::ostringstream text;
    text.precision(4);
    text << "bodies." << gap.a << " (" << setup.bodies[static_cast<std::size_t>(gap.a)].body.name << ") ";
    if (gap.b >= 0) {
      const std::string& other = setup.bodies[static_cast<std::size_t>(gap.b)].body.name;
      text << (gap.gap <= 0 ? "overlaps bodies." : "is too close to bodies.") << gap.b << " (" << other << ")";
    } else {
      text << (gap.gap <= 0 ? "reaches outside the domain" : "is too close to the edge of the domain");
    }
    text << " at t = 0, near (" << gap.point.transpose() << "): the gap is " << gap.gap << ", the overlapping grids need "
         << least_gap << " at this grid.factor";
    throw InputError(text.str());
  }
}

template void check_clearance<1>(const SimulationSetup<1>&, double);
template void check_clearance<2>(const SimulationSetup<2>&, double);

}  // namespace mortise
