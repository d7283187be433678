#include "mortise/coupler/reference_map/fast_transform.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mortise {
namespace {

/// The one-dimensional transform of a direction.
struct Axis {
  int first = 0, count = 0;  // points that take part
  fftw_r2r_kind forward{}, backward{};
  double scale = 1;                              // backward(forward(f)) = scale · f
  bool low_weight = false, high_weight = false;  // the first, last point weighs ½
  std::vector<double> angle;                     // θ of each coefficient
};

Axis axis_of(const PressureProblem& problem, std::size_t d, int points) {
  using enum PressureEnd;
  const PressureEnd low = problem.ends[2 * d], high = problem.ends[2 * d + 1];
  const bool nodes = problem.place == PressurePlace::nodes;
  const int n = problem.grid->cells[d];
  const auto angles = [n](int count, double shift) {
    std::vector<double> theta;
    for (int k = 0; k < count; ++k) theta.push_back(std::numbers::pi * (k + shift) / n);
    return theta;
  };
  if (low == periodic) {
    Axis axis{0, n, FFTW_R2HC, FFTW_HC2R, double(n), false, false, {}};
    for (int k = 0; k < n; ++k) axis.angle.push_back(2 * std::numbers::pi * std::min(k, n - k) / n);
    return axis;
  }
  const double scale = 2.0 * n;
  if (low == neumann && high == neumann)
    return nodes ? Axis{0, points, FFTW_REDFT00, FFTW_REDFT00, scale, true, true, angles(points, 0)}
                 : Axis{0, n, FFTW_REDFT10, FFTW_REDFT01, scale, false, false, angles(n, 0)};
  if (low == dirichlet && high == dirichlet)
    return nodes ? Axis{1, n - 1, FFTW_RODFT00, FFTW_RODFT00, scale, false, false, angles(n - 1, 1)}
                 : Axis{0, n, FFTW_RODFT10, FFTW_RODFT01, scale, false, false, angles(n, 1)};
  if (low == neumann)
    return nodes ? Axis{0, n, FFTW_REDFT01, FFTW_REDFT10, scale, true, false, angles(n, 0.5)}
                 : Axis{0, n, FFTW_REDFT11, FFTW_REDFT11, scale, false, false, angles(n, 0.5)};
  return nodes ? Axis{1, n, FFTW_RODFT01, FFTW_RODFT10, scale, false, true, angles(n, 0.5)}
               : Axis{0, n, FFTW_RODFT11, FFTW_RODFT11, scale, false, false, angles(n, 0.5)};
}

/// 1/(scale · eigenvalue of A); 0 for the constant.
double inverse_eigenvalue(const PressureProblem& problem, double theta_x, double theta_y, double scale) {
  const double aspect = problem.grid->spacing[1] / problem.grid->spacing[0];
  const auto K = [](double theta) { return 4 * std::sin(theta / 2) * std::sin(theta / 2); };
  const auto M = [&](double theta) { return problem.place == PressurePlace::nodes ? (2 + std::cos(theta)) / 3 : 1.0; };
  const double value = aspect * K(theta_x) * M(theta_y) + M(theta_x) * K(theta_y) / aspect;
  return theta_x == 0 && theta_y == 0 ? 0 : 1 / (scale * value);
}

struct FreeFFTW {
  void operator()(double* p) const { fftw_free(p); }
};
using Buffer = std::unique_ptr<double[], FreeFFTW>;

}  // namespace

struct FastTransform::Plans {
  Index<2> points;
  Axis x, y;
  bool complex = false;  // periodic both ways: half of the complex transform, twice as fast as two passes of real ones
  Buffer values, coefficients;
  std::vector<double> factors;  // of the coefficients
  fftw_plan forward{}, backward{};

  Plans(const PressureProblem& problem, Index<2> points_);
  ~Plans() {
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
  void make_real(const PressureProblem& problem);
  void make_complex(const PressureProblem& problem);
};

FastTransform::Plans::Plans(const PressureProblem& problem, Index<2> points_)
    : points(points_), x(axis_of(problem, 0, points_[0])), y(axis_of(problem, 1, points_[1])) {
  complex = x.forward == FFTW_R2HC && y.forward == FFTW_R2HC;
  const auto doubles = static_cast<std::size_t>(y.count) * static_cast<std::size_t>(x.count + 2);
  values.reset(fftw_alloc_real(doubles));
  coefficients.reset(fftw_alloc_real(doubles));
  if (complex)
    make_complex(problem);
  else
    make_real(problem);
}

void FastTransform::Plans::make_real(const PressureProblem& problem) {
  forward = fftw_plan_r2r_2d(y.count, x.count, values.get(), coefficients.get(), y.forward, x.forward, FFTW_ESTIMATE);
  backward =
      fftw_plan_r2r_2d(y.count, x.count, coefficients.get(), values.get(), y.backward, x.backward, FFTW_ESTIMATE);
  for (const double theta_y : y.angle)
    for (const double theta_x : x.angle)
      factors.push_back(inverse_eigenvalue(problem, theta_x, theta_y, x.scale * y.scale));
}

void FastTransform::Plans::make_complex(const PressureProblem& problem) {
  auto* const z = reinterpret_cast<fftw_complex*>(coefficients.get());
  forward = fftw_plan_dft_r2c_2d(y.count, x.count, values.get(), z, FFTW_ESTIMATE);
  backward = fftw_plan_dft_c2r_2d(y.count, x.count, z, values.get(), FFTW_ESTIMATE);
  for (const double theta_y : y.angle)
    for (int k = 0; k <= x.count / 2; ++k)
      for (int part = 0; part < 2; ++part)
        factors.push_back(
            inverse_eigenvalue(problem, x.angle[static_cast<std::size_t>(k)], theta_y, x.scale * y.scale));
}

FastTransform::FastTransform(const PressureProblem& problem, Index<2> points)
    : plans_(std::make_unique<Plans>(problem, points)) {}
FastTransform::~FastTransform() = default;

void FastTransform::solve(const double* b, double* p) {
  Plans& plans = *plans_;
  const Axis &x = plans.x, &y = plans.y;
  const std::ptrdiff_t stride = plans.points[0];
  double* const values = plans.values.get();
  for (int j = 0; j < y.count; ++j) {
    double* const row = values + static_cast<std::ptrdiff_t>(j) * x.count;
    const double* const from = b + (y.first + j) * stride + x.first;
    const double weight = (j == 0 && y.low_weight) || (j == y.count - 1 && y.high_weight) ? 2 : 1;
    for (int i = 0; i < x.count; ++i) row[i] = weight * from[i];
    if (x.low_weight) row[0] *= 2;
    if (x.high_weight) row[x.count - 1] *= 2;
  }
  fftw_execute(plans.forward);
  double* const coefficients = plans.coefficients.get();
  const double* const factors = plans.factors.data();
  for (std::size_t k = 0; k < plans.factors.size(); ++k) coefficients[k] *= factors[k];
  fftw_execute(plans.backward);
  if (x.count < plans.points[0] || y.count < plans.points[1])
    std::fill_n(p, static_cast<std::ptrdiff_t>(plans.points[1]) * stride, 0.0);
  for (int j = 0; j < y.count; ++j)
    std::copy_n(values + static_cast<std::ptrdiff_t>(j) * x.count, x.count, p + (y.first + j) * stride + x.first);
}

}  // namespace mortise
