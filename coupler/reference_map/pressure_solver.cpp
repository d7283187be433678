#include "mortise/coupler/reference_map/pressure_solver.hpp"

#include <algorithm>

#include "mortise/coupler/reference_map/hypre_solver.hpp"
#include "mortise/coupler/reference_map/multigrid.hpp"
#include "mortise/coupler/reference_map/transform_solver.hpp"
#include "mortise/coupler/reference_map/variable_solver.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

using Maker = std::unique_ptr<PressureSolver> (*)(const PressureProblem&);

std::unique_ptr<PressureSolver> make_multigrid_solver(const PressureProblem& problem) {
  return std::make_unique<VariableSolver>(problem, make_multigrid(problem));
}

class AutomaticSolver : public PressureSolver {
 public:
  explicit AutomaticSolver(const PressureProblem& problem) : problem_(problem) {}

  int solve(const Field<2>& right, const Field<2>* density, Field<2>& pressure, double energy) override {
    const bool multigrid = density && suits_multigrid(problem_.grid->cells);
    std::unique_ptr<PressureSolver>& solver = multigrid ? multigrid_ : transform_;
    if (!solver) solver = multigrid ? make_multigrid_solver(problem_) : make_transform_solver(problem_);
    return solver->solve(right, density, pressure, energy);
  }

 private:
  PressureProblem problem_;
  std::unique_ptr<PressureSolver> transform_, multigrid_;  // what has been needed so far
};

std::unique_ptr<PressureSolver> make_automatic_solver(const PressureProblem& problem) {
  return std::make_unique<AutomaticSolver>(problem);
}

const Registry<Maker>& solvers() {
  static const Registry<Maker> registry("pressure solver", {{"automatic", make_automatic_solver},
                                                            {"transform", make_transform_solver},
                                                            {"multigrid", make_multigrid_solver},
                                                            {"hypre", make_hypre_solver}});
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
