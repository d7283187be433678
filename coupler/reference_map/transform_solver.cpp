#include "mortise/coupler/reference_map/transform_solver.hpp"

#include <optional>
#include <vector>

#include "mortise/coupler/reference_map/fast_transform.hpp"
#include "mortise/coupler/reference_map/variable_solver.hpp"

namespace mortise {
namespace {

/// The inverse for density 1: rᵀA⁻¹r ≤ ρ_max rᵀA₁⁻¹r.
class TransformPreconditioner : public Preconditioner {
 public:
  explicit TransformPreconditioner(std::shared_ptr<FastTransform> transform) : transform_(std::move(transform)) {}
  void set(const VariableOperator& matrix) override { largest_density_ = matrix.largest_density(); }
  void apply(const double* r, double* z) override { transform_->solve(r, z); }
  double bound() const override { return largest_density_; }

 private:
  std::shared_ptr<FastTransform> transform_;
  double largest_density_ = 1;
};

class TransformSolver : public PressureSolver {
 public:
  explicit TransformSolver(const PressureProblem& problem)
      : problem_(problem),
        whole_(*problem.grid, problem.place),
        transform_(std::make_shared<FastTransform>(problem, whole_.points())),
        values_(whole_.count()) {}

  int solve(const Field<2>& right, const Field<2>* density, Field<2>& pressure, double energy) override {
    if (density) {
      if (!variable_) variable_.emplace(problem_, std::make_unique<TransformPreconditioner>(transform_));
      return variable_->solve(right, density, pressure, energy);
    }
    whole_.gather(right, values_.data(), whole_.points()[0]);
    transform_->solve(values_.data(), values_.data());
    whole_.scatter(values_.data(), whole_.points()[0], pressure);
    return 0;
  }

 private:
  PressureProblem problem_;
  WholeGrid whole_;
  std::shared_ptr<FastTransform> transform_;
  std::vector<double> values_;
  std::optional<VariableSolver> variable_;
};

}  // namespace

std::unique_ptr<PressureSolver> make_transform_solver(const PressureProblem& problem) {
  return std::make_unique<TransformSolver>(problem);
}

}  // namespace mortise
