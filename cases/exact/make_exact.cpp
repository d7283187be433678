#include <functional>

#include "mortise/cases/exact/elastic_cases.hpp"
#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/isentropic_vortex.hpp"
#include "mortise/cases/exact/plane_riemann.hpp"
#include "mortise/cases/exact/rigid_piston.hpp"
#include "mortise/cases/exact/shock_on_massless_body.hpp"
#include "mortise/cases/exact/uniform_flow.hpp"
#include "mortise/cases/exact/weak_shock_on_cylinder.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

template <int Dim>
using Maker = std::function<std::unique_ptr<ExactSolution<Dim>>(const CaseDescription&)>;

template <int Dim, class Solution>
std::unique_ptr<ExactSolution<Dim>> make(const CaseDescription& description) {
  return std::make_unique<Solution>(description);
}

template <int Dim>
Registry<Maker<Dim>> solutions();

template <>
Registry<Maker<1>> solutions<1>() {
  return {"exact solution in one dimension",
          {{"riemann", make<1, PlaneRiemann<1>>},
           {"uniform", make<1, UniformFlow<1>>},
           {"rigid_piston", make<1, RigidPiston>},
           {"shock_on_massless_body", make<1, ShockOnMasslessBody>}}};
}

template <>
Registry<Maker<2>> solutions<2>() {
  std::vector<std::pair<std::string, Maker<2>>> all = elastic_solutions();
  all.insert(all.end(), {{"riemann", make<2, PlaneRiemann<2>>},
                         {"uniform", make<2, UniformFlow<2>>},
                         {"vortex", make<2, IsentropicVortex>},
                         {"weak_shock_on_free_cylinder", make<2, WeakShockOnCylinder>}});
  return {"exact solution in two dimensions", std::move(all)};
}

}  // namespace

template <int Dim>
std::unique_ptr<ExactSolution<Dim>> make_exact(const CaseDescription& description) {
  if (description.exact.empty()) return nullptr;
  return solutions<Dim>().at(description.exact)(description);
}

template std::unique_ptr<ExactSolution<1>> make_exact<1>(const CaseDescription&);
template std::unique_ptr<ExactSolution<2>> make_exact<2>(const CaseDescription&);

}  // namespace mortise
