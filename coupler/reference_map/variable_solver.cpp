#include "mortise/coupler/reference_map/variable_solver.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/simd.hpp"

namespace mortise {
namespace {

constexpr int most_iterations = 400;
constexpr double smallest = 1e-280;  // nothing to solve for

/// a · b over the first n values, in an order that depends on n alone.
double dot(const double* a, const double* b, std::size_t n) {
  Pack sum{}, other{};
  std::size_t k = 0;
  for (; k + 2 * simd_width <= n; k += 2 * simd_width) {
    sum = sum + load(a + k) * load(b + k);
    other = other + load(a + k + simd_width) * load(b + k + simd_width);
  }
  sum = sum + other;
  double total = 0;
  for (int l = 0; l < simd_width; ++l) total += sum[l];
  for (; k < n; ++k) total += a[k] * b[k];
  return total;
}

}  // namespace

VariableSolver::VariableSolver(const PressureProblem& problem, std::unique_ptr<Preconditioner> preconditioner)
    : problem_(problem),
      whole_(*problem.grid, problem.place),
      cells_(*problem.grid, PressurePlace::cells),
      matrix_(problem, whole_.points()),
      preconditioner_(std::move(preconditioner)),
      density_(cells_.count(), 1.0),
      d_(matrix_.padded()) {
  for (Vector* v : {&b_, &x_, &r_, &z_, &q_}) v->resize(whole_.count() + VariableOperator::slack);
}

int VariableSolver::solve(const Field<2>& right, const Field<2>* density, Field<2>& pressure, double energy) {
  const std::ptrdiff_t stride = whole_.points()[0];
  if (density) cells_.gather(*density, density_.data(), problem_.grid->cells[0]);
  matrix_.set_density(density_.data());
  preconditioner_->set(matrix_);
  whole_.gather(right, b_.data(), stride);
  whole_.gather(pressure, x_.data(), stride);
  clear_fixed(x_);
  clear_fixed(b_);
  if (problem_.singular()) {
    remove_mean(b_);
    remove_mean(x_);
  }
  const int iterations = iterate(energy);
  whole_.scatter(x_.data(), stride, pressure);
  return iterations;
}

/// p at Dirichlet nodes is known to be 0: they take no part.
void VariableSolver::clear_fixed(Vector& v) const {
  if (problem_.place == PressurePlace::cells) return;
  const Index<2> n = whole_.points();
  const auto zero = [&](std::size_t side) { return problem_.ends[side] == PressureEnd::dirichlet; };
  for (int j = 0; j < n[1]; ++j) {
    double* const row = v.data() + static_cast<std::ptrdiff_t>(j) * n[0];
    if ((zero(2) && j == 0) || (zero(3) && j == n[1] - 1)) std::fill_n(row, n[0], 0.0);
    if (zero(0)) row[0] = 0;
    if (zero(1)) row[n[0] - 1] = 0;
  }
}
void VariableSolver::remove_mean(Vector& v) const {
  const std::size_t n = whole_.count();
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += v[k];
  const double mean = sum / static_cast<double>(n);
  for (std::size_t k = 0; k < n; ++k) v[k] -= mean;
}

/// d = v in the layout of the matrix, plus β d.
void VariableSolver::turn(const Vector& v, double beta) {
  const Index<2> n = whole_.points();
  for (int j = 0; j < n[1]; ++j) {
    double* const to = d_.data() + matrix_.first() + j * matrix_.stride();
    const double* const from = v.data() + static_cast<std::ptrdiff_t>(j) * n[0];
    for (int i = 0; i < n[0]; ++i) to[i] = from[i] + beta * to[i];
  }
}
double VariableSolver::dot_direction(const Vector& v) const {
  const Index<2> n = whole_.points();
  double sum = 0;
  for (int j = 0; j < n[1]; ++j)
    sum += dot(d_.data() + matrix_.first() + j * matrix_.stride(), v.data() + static_cast<std::ptrdiff_t>(j) * n[0],
               static_cast<std::size_t>(n[0]));
  return sum;
}
/// x += α d
void VariableSolver::move(double alpha) {
  const Index<2> n = whole_.points();
  for (int j = 0; j < n[1]; ++j) {
    const double* const d = d_.data() + matrix_.first() + j * matrix_.stride();
    double* const x = x_.data() + static_cast<std::ptrdiff_t>(j) * n[0];
    for (int i = 0; i < n[0]; ++i) x[i] += alpha * d[i];
  }
}

/// Preconditioned conjugate gradients. The error e of x satisfies eᵀA e = rᵀA⁻¹r ≤ bound rᵀz, which is known in every
/// iteration.
int VariableSolver::iterate(double energy) {
  const std::size_t n = whole_.count();
  std::fill(d_.begin(), d_.end(), 0.0);
  turn(x_, 0);
  matrix_.apply(d_.data(), q_.data());
  for (std::size_t k = 0; k < n; ++k) r_[k] = b_[k] - q_[k];
  const double contraction = preconditioner_->contraction();
  double rz = 0;
  for (int iteration = 0; iteration <= most_iterations; ++iteration) {
    preconditioner_->apply(r_.data(), z_.data());
    const double next = dot(r_.data(), z_.data(), n);
    const double scale = std::max(energy, std::abs(dot(x_.data(), b_.data(), n)));
    const double error = preconditioner_->bound() * next, allowed = problem_.tolerance * problem_.tolerance * scale;
    if (error <= allowed || next <= smallest) return iteration;
    if (error * contraction * contraction <= allowed) {
      for (std::size_t k = 0; k < n; ++k) x_[k] += z_[k];
      return iteration;
    }
    if (!std::isfinite(next)) break;
    turn(z_, iteration == 0 ? 0 : next / rz);
    rz = next;
    matrix_.apply(d_.data(), q_.data());
    const double alpha = rz / dot_direction(q_);
    move(alpha);
    for (std::size_t k = 0; k < n; ++k) r_[k] -= alpha * q_[k];
  }
  throw NumericalError("the pressure did not converge in " + std::to_string(most_iterations) + " iterations");
}

}  // namespace mortise
