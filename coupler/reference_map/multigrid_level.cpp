#include "mortise/coupler/reference_map/multigrid_level.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mortise/grids/core/simd.hpp"

namespace mortise {
namespace {

constexpr std::ptrdiff_t margin = 16, gap = 48;  // floats before the first point, and between rows

}  // namespace

MultigridLevel::MultigridLevel(PressurePlace place, const std::array<PressureEnd, 4>& ends, Index<2> cells,
                               double aspect)
    : place_(place), ends_(ends), cells_(cells), points_(cells), aspect_(aspect) {
  for (std::size_t d = 0; d < 2; ++d)
    if (place == PressurePlace::nodes && !periodic(d)) ++points_[d];
  stride_ = (points_[0] + gap) / 16 * 16;
  first_ = stride_ + margin;
  size_ = static_cast<std::size_t>(stride_ * (points_[1] + 3));
  for (Array* array : {&b, &x, &west_, &inverse_diagonal_, &old_, &r_}) array->assign(size_, 0.0F);
  if (place == PressurePlace::cells) south_.assign(size_, 0.0F);
  const double a = aspect, c = 1 / aspect;
  own_ = static_cast<float>((a + c) / 3);
  along_x_ = static_cast<float>(c / 6 - a / 3);
  along_y_ = static_cast<float>(a / 6 - c / 3);
  across_ = static_cast<float>(-(a + c) / 6);
  // The largest eigenvalue of a cell's matrix over its diagonal bounds that of their sum.
  largest_ = place == PressurePlace::cells ? 2.0F : static_cast<float>(std::max(a, c) / ((a + c) / 3));
}

Spectrum MultigridLevel::rough() const {
  return place_ == PressurePlace::cells ? Spectrum{0.45F, largest_} : Spectrum{0.4F * largest_, largest_};
}

Spectrum MultigridLevel::all() const {
  const double theta = std::numbers::pi / (std::max(cells_[0], cells_[1]) * (periodic(0) || periodic(1) ? 0.5 : 1));
  return {static_cast<float>(0.2 * (1 - std::cos(theta))), largest_};
}

void MultigridLevel::set_finest(const VariableOperator& matrix) {
  for (int j = -1; j <= points_[1]; ++j) {
    const std::ptrdiff_t from = matrix.first() + j * matrix.stride();
    for (int i = -1; i <= points_[0]; ++i) {
      west_[static_cast<std::size_t>(at(i, j))] = static_cast<float>(matrix.west()[from + i]);
      if (place_ == PressurePlace::cells)
        south_[static_cast<std::size_t>(at(i, j))] = static_cast<float>(matrix.south()[from + i]);
    }
  }
  // Here p beyond a Dirichlet side is −p, at twice the distance.
  if (place_ == PressurePlace::cells) {
    for (int j = 0; j < points_[1]; ++j)
      for (const std::size_t side : {0U, 1U})
        if (ends_[side] == PressureEnd::dirichlet)
          west_[static_cast<std::size_t>(at(side ? points_[0] : 0, j))] *= 0.5F;
    for (int i = 0; i < points_[0]; ++i)
      for (const std::size_t side : {2U, 3U})
        if (ends_[side] == PressureEnd::dirichlet)
          south_[static_cast<std::size_t>(at(i, side == 3 ? points_[1] : 0))] *= 0.5F;
  }
  finish_coefficients();
}

void MultigridLevel::average(const MultigridLevel& fine) {
  const std::ptrdiff_t s = fine.stride_;
  if (place_ == PressurePlace::cells) {
    for (int j = 0; j < points_[1]; ++j)
      for (int i = 0; i <= points_[0]; ++i) {
        const float* w = fine.west_.data() + fine.at(2 * i, 2 * j);
        west_[static_cast<std::size_t>(at(i, j))] = 0.5F * (w[0] + w[s]);
      }
    for (int j = 0; j <= points_[1]; ++j)
      for (int i = 0; i < points_[0]; ++i) {
        const float* w = fine.south_.data() + fine.at(2 * i, 2 * j);
        south_[static_cast<std::size_t>(at(i, j))] = 0.5F * (w[0] + w[1]);
      }
  } else {
    for (int j = 0; j < cells_[1]; ++j)
      for (int i = 0; i < cells_[0]; ++i) {
        const float* c = fine.west_.data() + fine.at(2 * i, 2 * j);
        west_[static_cast<std::size_t>(at(i, j))] = 0.25F * ((c[0] + c[1]) + (c[s] + c[s + 1]));
      }
    // A point owns the cell to its upper right: across a periodic side the ghosts of that of the other side.
    if (periodic(0))
      for (int j = 0; j < cells_[1]; ++j)
        west_[static_cast<std::size_t>(at(-1, j))] = west_[static_cast<std::size_t>(at(cells_[0] - 1, j))];
    if (periodic(1))
      for (int i = -1; i < cells_[0]; ++i)
        west_[static_cast<std::size_t>(at(i, -1))] = west_[static_cast<std::size_t>(at(i, cells_[1] - 1))];
  }
  finish_coefficients();
}

void MultigridLevel::finish_coefficients() {
  const auto fixed = [&](int i, int j) {
    if (place_ == PressurePlace::cells) return false;
    const auto zero = [&](std::size_t side) { return ends_[side] == PressureEnd::dirichlet; };
    return (zero(0) && i == 0) || (zero(1) && i == points_[0] - 1) || (zero(2) && j == 0) ||
           (zero(3) && j == points_[1] - 1);
  };
  const std::ptrdiff_t s = stride_;
  for (int j = 0; j < points_[1]; ++j) {
    float* const out = inverse_diagonal_.data() + at(0, j);
    const float* const w = west_.data() + at(0, j);
    if (place_ == PressurePlace::cells) {
      const float* const v = south_.data() + at(0, j);
      for (int i = 0; i < points_[0]; ++i) out[i] = 1 / ((w[i] + w[i + 1]) + (v[i] + v[i + s]));
      const auto twice = [&](int i, float weight) { out[i] = 1 / (1 / out[i] + weight); };
      if (ends_[0] == PressureEnd::dirichlet) twice(0, w[0]);
      if (ends_[1] == PressureEnd::dirichlet) twice(points_[0] - 1, w[points_[0]]);
      for (int i = 0; i < points_[0]; ++i) {
        if (ends_[2] == PressureEnd::dirichlet && j == 0) twice(i, v[i]);
        if (ends_[3] == PressureEnd::dirichlet && j == points_[1] - 1) twice(i, v[i + s]);
      }
    } else {
      for (int i = 0; i < points_[0]; ++i)
        out[i] = fixed(i, j) ? 0 : 1 / (own_ * ((w[i] + w[i - 1]) + (w[i - s] + w[i - s - 1])));
    }
  }
}

/// Cells: mirrored, with the sign of the end; nodes: nothing is beyond but across periodic sides.
void MultigridLevel::fill_ghosts(Array& q) const {
  const int nx = points_[0], ny = points_[1];
  const bool cells = place_ == PressurePlace::cells;
  const auto sign = [&](std::size_t side) {
    return !cells ? 0.0F : ends_[side] == PressureEnd::dirichlet ? -1.0F : 1.0F;
  };
  const float w = sign(0), e = sign(1), s = sign(2), n = sign(3);
  for (int j = 0; j < ny; ++j) {
    float* const row = q.data() + at(0, j);
    row[-1] = periodic(0) ? row[nx - 1] : w * row[0];
    row[nx] = periodic(0) ? row[0] : e * row[nx - 1];
  }
  float *const below = q.data() + at(-1, -1), *const above = q.data() + at(-1, ny);
  const float *const low = q.data() + at(-1, 0), *const high = q.data() + at(-1, ny - 1);
  for (int i = 0; i < nx + 2; ++i) {
    below[i] = periodic(1) ? high[i] : s * low[i];
    above[i] = periodic(1) ? low[i] : n * high[i];
  }
}

/// (A x) of the point at offset k.
template <PressurePlace place>
MORTISE_INLINE float product(const float* x, const float* w, const float* v, std::ptrdiff_t s, float own, float along_x,
                             float along_y, float across, std::ptrdiff_t i) {
  if constexpr (place == PressurePlace::cells) {
    return (w[i] * (x[i] - x[i - 1]) + w[i + 1] * (x[i] - x[i + 1])) +
           (v[i] * (x[i] - x[i - s]) + v[i + s] * (x[i] - x[i + s]));
  } else {
    const float sw = w[i - s - 1], se = w[i - s], nw = w[i - 1], ne = w[i], south = sw + se, north = nw + ne;
    return own * (south + north) * x[i] + along_x * ((sw + nw) * x[i - 1] + (se + ne) * x[i + 1]) +
           along_y * (south * x[i - s] + north * x[i + s]) +
           across * ((sw * x[i - s - 1] + se * x[i - s + 1]) + (nw * x[i + s - 1] + ne * x[i + s + 1]));
  }
}

/// old ← x + β (x − old) + α D⁻¹(b − A x); then the two change names.
template <PressurePlace place>
void MultigridLevel::step(float alpha, float beta) {
  const float own = own_, along_x = along_x_, along_y = along_y_, across = across_;
  const int n = points_[0];
  for (int j = 0; j < points_[1]; ++j) {
    const std::ptrdiff_t o = at(0, j), s = stride_;
    const float *__restrict const w = west_.data() + o, *__restrict const v = south_.data() + (south_.empty() ? 0 : o),
                                 *__restrict const q = x.data() + o, *__restrict const right = b.data() + o,
                                 *__restrict const d = inverse_diagonal_.data() + o;
    float* __restrict const to = old_.data() + o;
    for (std::ptrdiff_t i = 0; i < n; ++i)
      to[i] = q[i] + beta * (q[i] - to[i]) +
              alpha * d[i] * (right[i] - product<place>(q, w, v, s, own, along_x, along_y, across, i));
  }
  std::swap(x, old_);
}

template <PressurePlace place>
void MultigridLevel::residual() {
  const float own = own_, along_x = along_x_, along_y = along_y_, across = across_;
  const int n = points_[0];
  for (int j = 0; j < points_[1]; ++j) {
    const std::ptrdiff_t o = at(0, j), s = stride_;
    const float* __restrict const w = west_.data() + o, * __restrict const v = south_.data() + (south_.empty() ? 0 : o), * __restrict const q = x.data() + o, * __restrict const right = b.data() + o;
    float* __restrict const to = r_.data() + o;
    for (std::ptrdiff_t i = 0; i < n; ++i)
      to[i] = right[i] - product<place>(q, w, v, s, own, along_x, along_y, across, i);
  }
}

void MultigridLevel::smooth(bool from_zero, int steps, Spectrum spectrum) {
  const bool cells = place_ == PressurePlace::cells;
  const float theta = 0.5F * (spectrum.high + spectrum.low), delta = 0.5F * (spectrum.high - spectrum.low);
  float rho = delta / theta;
  for (int k = 0; k < steps; ++k) {
    float alpha = 1 / theta, beta = 0;
    if (k > 0) {
      const float next = 1 / (2 * theta / delta - rho);
      alpha = 2 * next / delta, beta = next * rho;
      rho = next;
    }
    if (k == 0 && from_zero) {
      for (int j = 0; j < points_[1]; ++j) {
        const std::ptrdiff_t o = at(0, j);
        const float* __restrict const right = b.data() + o, * __restrict const d = inverse_diagonal_.data() + o;
        float* __restrict const q = x.data() + o, * __restrict const before = old_.data() + o;
        for (int i = 0; i < points_[0]; ++i) q[i] = alpha * d[i] * right[i], before[i] = 0;
      }
      continue;
    }
    fill_ghosts(x);
    if (cells)
      step<PressurePlace::cells>(alpha, beta);
    else
      step<PressurePlace::nodes>(alpha, beta);
  }
}

void MultigridLevel::restrict_from(MultigridLevel& fine) {
  fine.fill_ghosts(fine.x);
  const bool cells = place_ == PressurePlace::cells;
  if (cells)
    fine.residual<PressurePlace::cells>();
  else
    fine.residual<PressurePlace::nodes>();
  fine.fill_ghosts(fine.r_);
  const std::ptrdiff_t s = fine.stride_;
  for (int j = 0; j < points_[1]; ++j) {
    const float* __restrict const r = fine.r_.data() + fine.at(0, 2 * j);
    float* __restrict const to = b.data() + at(0, j);
    if (cells)
      for (std::ptrdiff_t i = 0; i < points_[0]; ++i) {
        const float* const q = r + 2 * i;
        const auto row = [](const float* p) { return 0.25F * (p[-1] + p[2]) + 0.75F * (p[0] + p[1]); };
        to[i] = 0.25F * (row(q - s) + row(q + 2 * s)) + 0.75F * (row(q) + row(q + s));
      }
    else
      for (std::ptrdiff_t i = 0; i < points_[0]; ++i) {
        const float* const q = r + 2 * i;
        const auto row = [](const float* p) { return 0.5F * (p[-1] + p[1]) + p[0]; };
        to[i] = 0.5F * (row(q - s) + row(q + s)) + row(q);
      }
  }
}

void MultigridLevel::correct_from(MultigridLevel& coarse) {
  coarse.fill_ghosts(coarse.x);
  const std::ptrdiff_t s = coarse.stride_;
  const bool cells = place_ == PressurePlace::cells;
  for (int j = 0; j < points_[1]; ++j) {
    const bool odd = j % 2 != 0;
    const float* __restrict const here = coarse.x.data() + coarse.at(0, j / 2);
    float* __restrict const to = x.data() + at(0, j);
    if (cells) {
      const float* __restrict const other = odd ? here + s : here - s;
      for (std::ptrdiff_t i = 0; i < coarse.points_[0]; ++i) {
        const float middle = 0.75F * here[i] + 0.25F * other[i], west = 0.75F * here[i - 1] + 0.25F * other[i - 1],
                    east = 0.75F * here[i + 1] + 0.25F * other[i + 1];
        to[2 * i] += 0.75F * middle + 0.25F * west;
        to[2 * i + 1] += 0.75F * middle + 0.25F * east;
      }
    } else {
      const float* __restrict const other = odd ? here + s : here;
      for (std::ptrdiff_t i = 0; i < cells_[0] / 2; ++i) {
        const float middle = 0.5F * (here[i] + other[i]), east = 0.5F * (here[i + 1] + other[i + 1]);
        to[2 * i] += middle;
        to[2 * i + 1] += 0.5F * (middle + east);
      }
      if (!periodic(0)) to[points_[0] - 1] += 0.5F * (here[coarse.points_[0] - 1] + other[coarse.points_[0] - 1]);
    }
  }
}

}  // namespace mortise
