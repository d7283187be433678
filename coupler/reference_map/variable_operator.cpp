#include "mortise/coupler/reference_map/variable_operator.hpp"

#include <algorithm>

#include "mortise/grids/core/simd.hpp"

namespace mortise {

VariableOperator::VariableOperator(const PressureProblem& problem, Index<2> points)
    : problem_(problem), points_(points), stride_((points[0] + 2 + 7) / 8 * 8 + 8) {
  padded_ = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(points[1] + 2) + 2 * slack;
  x_.assign(padded_, 0.0);
  if (problem.place == PressurePlace::cells) y_.assign(padded_, 0.0);
}

void VariableOperator::set_density(const double* density) {
  const Index<2>& n = problem_.grid->cells;
  largest_density_ = *std::max_element(density, density + static_cast<std::ptrdiff_t>(n[0]) * n[1]);
  if (problem_.place == PressurePlace::cells)
    set_edges(density);
  else
    set_cells(density);
}

void VariableOperator::set_edges(const double* density) {
  const int nx = points_[0], ny = points_[1];
  const double aspect = problem_.grid->spacing[1] / problem_.grid->spacing[0];
  // Weight of the edge between a cell and what lies beyond a side: half the distance to p = 0, none to a Neumann side.
  const auto at_end = [&](std::size_t side, double here, double opposite) {
    switch (problem_.ends[side]) {
      case PressureEnd::periodic:
        return 2 / (here + opposite);
      case PressureEnd::dirichlet:
        return 2 / here;
      default:
        return 0.0;
    }
  };
  for (int j = 0; j < ny; ++j) {
    const double* const rho = density + static_cast<std::ptrdiff_t>(j) * nx;
    double* const w = x_.data() + first() + j * stride_;
    for (int i = 1; i < nx; ++i) w[i] = aspect * 2 / (rho[i - 1] + rho[i]);
    w[0] = aspect * at_end(0, rho[0], rho[nx - 1]);
    w[nx] = aspect * at_end(1, rho[nx - 1], rho[0]);
  }
  const double* const top = density + static_cast<std::ptrdiff_t>(ny - 1) * nx;
  for (int j = 0; j <= ny; ++j) {
    const double *const above = density + static_cast<std::ptrdiff_t>(j) * nx, *const below = above - nx;
    double* const w = y_.data() + first() + j * stride_;
    for (int i = 0; i < nx; ++i)
      w[i] = (j == 0    ? at_end(2, above[i], top[i])
              : j == ny ? at_end(3, below[i], density[i])
                        : 2 / (below[i] + above[i])) /
             aspect;
  }
}

void VariableOperator::set_cells(const double* density) {
  const Index<2>& n = problem_.grid->cells;
  for (int j = -1; j <= n[1]; ++j)
    for (int i = -1; i <= n[0]; ++i) {
      const bool inside =
          (problem_.grid->periodic[0] || (i >= 0 && i < n[0])) && (problem_.grid->periodic[1] || (j >= 0 && j < n[1]));
      const int k = (i + n[0]) % n[0], l = (j + n[1]) % n[1];
      x_[static_cast<std::size_t>(first() + j * stride_ + i)] =
          inside ? 1 / density[static_cast<std::ptrdiff_t>(l) * n[0] + k] : 0;
    }
}

void VariableOperator::fill_ghosts(double* p) const {
  const int nx = points_[0], ny = points_[1];
  double* const q = p + first();
  for (int j = 0; j < ny; ++j) {
    double* const row = q + j * stride_;
    row[-1] = problem_.grid->periodic[0] ? row[nx - 1] : 0;
    row[nx] = problem_.grid->periodic[0] ? row[0] : 0;
  }
  double *const below = q - stride_, *const above = q + ny * stride_;
  if (problem_.grid->periodic[1]) {
    std::copy_n(above - stride_ - 1, nx + 2, below - 1);
    std::copy_n(q - 1, nx + 2, above - 1);
  } else {
    std::fill_n(below - 1, nx + 2, 0.0);
    std::fill_n(above - 1, nx + 2, 0.0);
  }
}

void VariableOperator::apply(double* p, double* Ap) const {
  fill_ghosts(p);
  if (problem_.place == PressurePlace::cells)
    apply_cells(p, Ap);
  else
    apply_nodes(p, Ap);
}

void VariableOperator::apply_cells(const double* p, double* Ap) const {
  const std::ptrdiff_t s = stride_;
  for (int j = 0; j < points_[1]; ++j) {
    const std::ptrdiff_t o = first() + j * s;
    const double *const q = p + o, *const x = x_.data() + o, *const y = y_.data() + o;
    double* const out = Ap + static_cast<std::ptrdiff_t>(j) * points_[0];
    for (int i = 0; i < points_[0]; i += simd_width) {
      const Pack here = load(q + i);
      store(out + i, load(x + i) * (here - load(q + i - 1)) + load(x + i + 1) * (here - load(q + i + 1)) +
                         load(y + i) * (here - load(q + i - s)) + load(y + i + s) * (here - load(q + i + s)));
    }
  }
}

void VariableOperator::apply_nodes(const double* p, double* Ap) const {
  // Entries of a cell's matrix: with the node itself, its neighbours along x and y, and the one across.
  const double a = problem_.grid->spacing[1] / problem_.grid->spacing[0], b = 1 / a;
  const double own = (a + b) / 3, along_x = b / 6 - a / 3, along_y = a / 6 - b / 3, across = -(a + b) / 6;
  const std::ptrdiff_t s = stride_;
  const auto zero_end = [&](std::size_t side) { return problem_.ends[side] == PressureEnd::dirichlet; };
  for (int j = 0; j < points_[1]; ++j) {
    const std::ptrdiff_t o = first() + j * s;
    const double *const q = p + o, *const c = x_.data() + o;
    double* const out = Ap + static_cast<std::ptrdiff_t>(j) * points_[0];
    for (int i = 0; i < points_[0]; i += simd_width) {
      const Pack sw = load(c + i - s - 1), se = load(c + i - s), nw = load(c + i - 1), ne = load(c + i);
      const Pack south = sw + se, north = nw + ne;
      Pack sum = own * (south + north) * load(q + i);
      sum = sum + along_x * ((sw + nw) * load(q + i - 1) + (se + ne) * load(q + i + 1));
      sum = sum + along_y * (south * load(q + i - s) + north * load(q + i + s));
      sum = sum + across * ((sw * load(q + i - s - 1) + se * load(q + i - s + 1)) +
                            (nw * load(q + i + s - 1) + ne * load(q + i + s + 1)));
      store(out + i, sum);
    }
    if ((zero_end(2) && j == 0) || (zero_end(3) && j == points_[1] - 1)) std::fill_n(out, points_[0], 0.0);
    if (zero_end(0)) out[0] = 0;
    if (zero_end(1)) out[points_[0] - 1] = 0;
  }
}

}  // namespace mortise
