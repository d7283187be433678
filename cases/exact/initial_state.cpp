#include "mortise/cases/exact/initial_state.hpp"

#include "mortise/cases/exact/isentropic_vortex.hpp"
#include "mortise/cases/exact/plane_riemann.hpp"
#include "mortise/cases/exact/uniform_flow.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

Expression of_position(const std::string& formula) { return {formula.empty() ? "0" : formula, {"x", "y"}}; }

}  // namespace

template <int Dim>
InitialState<Dim>::InitialState(const CaseDescription& description) {
  const InitialDescription& initial = description.initial;
  if (initial.kind == "regions") {
    for (const RegionDescription& region : initial.regions) {
      std::vector<Expression> where;
      if (!region.where.empty()) where.push_back(of_position(region.where));
      regions_.push_back({std::move(where), of_position(region.density), of_position(region.velocity_x),
                          of_position(region.velocity_y), of_position(region.pressure)});
    }
    return;
  }
  using Maker = std::unique_ptr<ExactSolution<Dim>> (*)(const CaseDescription&);
  const Maker plane = [](const CaseDescription& c) -> std::unique_ptr<ExactSolution<Dim>> {
    return std::make_unique<PlaneRiemann<Dim>>(c);
  };
  const Maker uniform = [](const CaseDescription& c) -> std::unique_ptr<ExactSolution<Dim>> {
    return std::make_unique<UniformFlow<Dim>>(c);
  };
  std::vector<std::pair<std::string, Maker>> kinds{
      {"uniform", uniform}, {"shock", plane}, {"riemann", plane}, {"regions", nullptr}};
  if constexpr (Dim == 2)
    kinds.emplace_back("vortex", [](const CaseDescription& c) -> std::unique_ptr<ExactSolution<2>> {
      return std::make_unique<IsentropicVortex>(c);
    });
  flow_ = Registry<Maker>("initial.kind", std::move(kinds)).at(initial.kind)(description);
}

template <int Dim>
Primitive<Dim> InitialState<Dim>::operator()(const Point<Dim>& x) const {
  if (flow_) return flow_->state(x, 0);
  double y = 0;
  if constexpr (Dim > 1) y = x[1];
  for (const Region& region : regions_) {
    if (!region.where.empty() && region.where[0](x[0], y) == 0) continue;
    Primitive<Dim> W;
    W.density = region.density(x[0], y);
    W.velocity[0] = region.velocity_x(x[0], y);
    if constexpr (Dim > 1) W.velocity[1] = region.velocity_y(x[0], y);
    W.pressure = region.pressure(x[0], y);
    return W;
  }
  throw InputError("no initial region contains the point (" + std::to_string(x[0]) + ", " + std::to_string(y) + ")");
}

template class InitialState<1>;
template class InitialState<2>;

}  // namespace mortise
