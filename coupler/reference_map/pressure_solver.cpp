#include "mortise/coupler/reference_map/pressure_solver.hpp"

#include <algorithm>

#include "mortise/coupler/reference_map/hypre_solver.hpp"
#include "mortise/coupler/reference_map/transform_solver.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

using Maker = std::unique_ptr<PressureSolver> (*)(const PressureProblem&);

const Registry<Maker>& solvers() {
  static const Registry<Maker> registry("pressure solver",
                                        {{"transform", make_transform_solver}, {"hypre", make_hypre_solver}});
  return registry;
}

}  // namespace

bool PressureProblem::singular() const {
  return std::none_of(ends.begin(), ends.end(), [](PressureEnd end) { return end == PressureEnd::dirichlet; });
}

std::vector<std::string> pressure_solver_keys() { return solvers().keys(); }

std::unique_ptr<PressureSolver> make_pressure_solver(const std::string& key, const PressureProblem& problem) {
  return solvers().at(key)(problem);
}

}  // namespace mortise
