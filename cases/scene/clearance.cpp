// Bodies must start inside the domain, apart from each other, with room for their grids.
#include <cmath>
#include <sstream>

#include "mortise/cases/scene/scene.hpp"
#include "mortise/coupler/gaps.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {

namespace {

template <int Dim>
std::string sentence(const CaseDescription& description, const ContactPoint<Dim>& gap, double least_gap) {
  const auto named = [&](int body) { return "bodies." + std::to_string(body) + " (" + description.bodies[static_cast<std::size_t>(body)].name + ")"; };
  const std::string other = gap.b >= 0 ? named(gap.b) : "the edge of the domain";
  std::ostringstream text;
  text.precision(4);
  text << description.bodies[static_cast<std::size_t>(gap.a)].place << ": " << named(gap.a) << ' ';
  if (gap.gap > 0)
    text << "is too close to " << other;
  else
    text << (gap.b >= 0 ? "overlaps " + other : "reaches outside the domain");
  text << " at t = 0 near (" << gap.point[0];
  if constexpr (Dim == 2) text << ", " << gap.point[1];
  text << "): ";
  if (gap.gap > 0)
    text << "the gap is " << gap.gap << " and the grids need " << least_gap << ", so set grid.factor to at least "
         << std::ceil(10.5 * description.grid_factor * least_gap / gap.gap) / 10 << " or make the gap wider";
  else
    text << "move it by at least " << least_gap - gap.gap;
  return text.str();
}

}  // namespace

template <int Dim>
void check_clearance(const CaseDescription& description, const SimulationSetup<Dim>& setup, double least_gap) {
  std::vector<GapBody<Dim>> shapes;
  for (std::size_t b = 0; b < setup.bodies.size(); ++b)
    shapes.push_back({setup.fluid.bodies[b].shape.atlas.get(), setup.bodies[b].outline.get(), setup.bodies[b].body.pose});
  std::array<bool, Dim> periodic{};
  for (std::size_t d = 0; d < Dim; ++d) periodic[d] = setup.fluid.boundaries.kind[2 * d] == BoundaryKind::periodic;
  const std::vector<ContactPoint<Dim>> gaps = find_gaps<Dim>(shapes, setup.fluid.domain, periodic, least_gap);
  if (!gaps.empty()) throw InputError(sentence(description, gaps.front(), least_gap));
}

template void check_clearance<1>(const CaseDescription&, const SimulationSetup<1>&, double);
template void check_clearance<2>(const CaseDescription&, const SimulationSetup<2>&, double);

}  // namespace mortise
