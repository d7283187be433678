// What a step reports of the cells that count, gathered a vector at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/grids/core/row_workspace.hpp"
#include "mortise/solid/systems.hpp"

namespace mortise::elastic {

/// Fills row[i] with 1 for the cells i that count, 0 elsewhere; active (indexed like the row) may be null.
inline void fill_weights(double* row, int nx, const std::uint8_t* active) {
  std::fill(row + row_start, row + nx + simd_width, 0.0);
  for (int i = 0; i < nx; ++i) row[i] = !active || active[i] != 0 ? 1.0 : 0.0;
}

template <class System>
class Findings {
 public:
  using State = typename System::template StateOf<Pack>;

  template <class Metrics>
  MORTISE_INLINE void add(const System& system, const State& W, const Vector<Pack>& displacement, const Metrics& m,
                          PackMask counts) {
    const Pack J = System::jacobian(W);
    least_j_ = min(select(counts, J, broadcast(std::numeric_limits<double>::infinity())), least_j_);
    spoiled_ = spoiled_ + select(counts, 0.0 * (sum(W.deformation) + sum(W.velocity) + sum(displacement)), Pack{});
    const PackMask good = counts & (J > 0);
    const Pack rate = system.wave_rate(choose(good, W, System::template at_rest<Pack>()), m);
    rate_ = max(rate_, select(good, rate, Pack{}));
  }
  ElasticStepResult result() const {
    const double least_j = -horizontal_max(-least_j_);
    bool finite = true;
    for (int k = 0; k < simd_width; ++k) finite = finite && spoiled_[k] == 0;
    const bool admissible = finite && least_j > 0;
    return {admissible ? horizontal_max(rate_) : std::numeric_limits<double>::infinity(), admissible, least_j};
  }

 private:
  MORTISE_INLINE static Pack sum(const Vector<Pack>& v) { return v.x + v.y; }
  MORTISE_INLINE static Pack sum(const SymmetricTensor<Pack>& A) { return (A.xx + A.xy) + A.yy; }
  MORTISE_INLINE static Pack sum(const Tensor<Pack>& A) { return (A.xx + A.xy) + (A.yx + A.yy); }

  Pack rate_{}, spoiled_{};  // spoiled: 0 as long as all numbers are finite
  Pack least_j_ = broadcast(std::numeric_limits<double>::infinity());
};

}  // namespace mortise::elastic
