// Geometry of the tiles of elastic_step.hpp, a vector of cells at a time: what a step kernel asks of a Cartesian and of
// a curvilinear tile. Area vectors point towards increasing index.
#pragma once

#include "mortise/grids/core/row_workspace.hpp"
#include "mortise/solid/cell_state.hpp"
#include "mortise/solid/elastic_step.hpp"

namespace mortise::elastic {

/// A face of a Cartesian tile; fluxes are per area.
template <int d>
struct AxisFace {
  Axis<d> normal;
  template <class System, class Flux>
  MORTISE_INLINE Flux through(const Flux& flux) const {
    return flux;
  }
};
/// A face of a curvilinear tile.
template <class T>
struct EdgeFace {
  explicit EdgeFace(const Vector<T>& S) {
    const T inverse = inverse_sqrt(dot(S, S));
    normal = inverse * S;
    area = inverse * dot(S, S);
  }
  template <class System, class Flux>
  MORTISE_INLINE Flux through(const Flux& flux) const {
    return System::scaled(area, flux);
  }
  Vector<T> normal;  // unit
  T area;            // |S|
};

class CartesianGeometry {
 public:
  using Metrics = HalfStepMetrics<Axis<0>, Axis<1>, Pack>;
  static constexpr int rows = 0;

  CartesianGeometry(const ElasticTile& tile, double dt, const RowWorkspace&, int)
      : courant_{dt / tile.spacing[0], dt / tile.spacing[1]}, inverse_{1 / tile.spacing[0], 1 / tile.spacing[1]} {}

  MORTISE_INLINE Metrics half_step_metrics(int, int, PackMask) const { return metrics(courant_); }
  MORTISE_INLINE Metrics rate_metrics(int, int) const { return metrics(inverse_); }
  MORTISE_INLINE AxisFace<0> west(int, int) const { return {}; }
  MORTISE_INLINE AxisFace<1> south(int, int) const { return {}; }
  AxisFace<0> west_side(int, int) const { return {}; }
  AxisFace<1> south_side(int, int) const { return {}; }
  /// Δt/V times what the four faces give to the cells.
  template <class System, class Flux>
  MORTISE_INLINE auto gain(const Flux& west, const Flux& east, const Flux& south, const Flux& north, int, int) const {
    const auto x = System::gain(System::difference(east, west), Axis<0>{});
    const auto y = System::gain(System::difference(north, south), Axis<1>{});
    return each(x, y, y, [this](Pack a, Pack b, Pack) { return courant_[0] * a + courant_[1] * b; });
  }

 private:
  MORTISE_INLINE static Metrics metrics(const std::array<double, 2>& factor) {
    return {{}, {}, broadcast(factor[0]), broadcast(factor[1])};
  }
  std::array<double, 2> courant_, inverse_;  // Δt/h_d, 1/h_d
};

/// Metrics are made row by row with the half step and kept for two rows.
class CurvilinearGeometry {
 public:
  using Metrics = HalfStepMetrics<Vector<Pack>, Vector<Pack>, Pack>;
  static constexpr int rows = 10;

  CurvilinearGeometry(const ElasticTile& tile, double dt, const RowWorkspace& work, int first_row)
      : x_(tile.x + tile.nodes->at(0, 0)),
        y_(tile.y + tile.nodes->at(0, 0)),
        pitch_(tile.nodes->stride),
        dt_(dt),
        rows_(work.row(first_row)),
        stride_(static_cast<std::ptrdiff_t>(work.stride())) {}

  /// Makes the metrics of a vector of cells, harmless ones where the mask is false.
  MORTISE_INLINE Metrics half_step_metrics(int i, int r, PackMask valid) const {
    prefetch_read(x_ + (r + 3) * pitch_ + i), prefetch_read(y_ + (r + 3) * pitch_ + i);
    const Pack one = broadcast(1.0), zero{};
    const Vector<Pack> sw = node<Pack>(i, r), se = node<Pack>(i + 1, r), nw = node<Pack>(i, r + 1),
                       ne = node<Pack>(i + 1, r + 1);
    Vector<Pack> west = edge(sw, nw), south = edge(se, sw);
    Pack area = 0.5 * ((ne.x - sw.x) * (nw.y - se.y) - (ne.y - sw.y) * (nw.x - se.x));
    west = each(west, {one, zero}, west, [valid](Pack a, Pack b, Pack) { return select(valid, a, b); });
    south = each(south, {one, zero}, south, [valid](Pack a, Pack b, Pack) { return select(valid, a, b); });
    area = select(valid, area, one);
    const Pack inverse = 1.0 / area;
    store_vector(wests(r) + i, west);
    store_vector(souths(r) + i, south);
    store(inverses(r) + i, inverse);
    const Pack factor = (0.5 * dt_) * inverse;
    return {west + edge(se, ne), south + edge(ne, nw), factor, factor};
  }
  /// Of rows whose northern neighbours have metrics.
  MORTISE_INLINE Metrics rate_metrics(int i, int r) const {
    const Pack factor = 0.5 * load(inverses(r) + i);
    return {load_vector(wests(r) + i) + load_vector(wests(r) + i + 1),
            load_vector(souths(r) + i) + load_vector(souths(r + 1) + i), factor, factor};
  }
  MORTISE_INLINE EdgeFace<Pack> west(int i, int r) const { return EdgeFace<Pack>(load_vector(wests(r) + i)); }
  MORTISE_INLINE EdgeFace<Pack> south(int i, int r) const { return EdgeFace<Pack>(load_vector(souths(r) + i)); }
  /// One face.
  EdgeFace<double> west_side(int i, int r) const {
    return EdgeFace<double>(edge(node<double>(i, r), node<double>(i, r + 1)));
  }
  EdgeFace<double> south_side(int i, int r) const {
    return EdgeFace<double>(edge(node<double>(i + 1, r), node<double>(i, r)));
  }
  template <class System, class Flux>
  MORTISE_INLINE auto gain(const Flux& west, const Flux& east, const Flux& south, const Flux& north, int i,
                           int r) const {
    const Vector<Pack> w = load_vector(wests(r) + i), e = load_vector(wests(r) + i + 1);
    const Vector<Pack> s = load_vector(souths(r) + i), n = load_vector(souths(r + 1) + i);
    const auto x = System::gain(east, e) - System::gain(west, w);
    const auto y = System::gain(north, n) - System::gain(south, s);
    const Pack factor = dt_ * load(inverses(r) + i);
    return each(x, y, y, [factor](Pack a, Pack b, Pack) { return factor * (a + b); });
  }

 private:
  template <class T>
  MORTISE_INLINE Vector<T> node(int i, int r) const {
    const std::ptrdiff_t at = r * pitch_ + i;
    if constexpr (std::is_same_v<T, Pack>)
      return {load(x_ + at), load(y_ + at)};
    else
      return {x_[at], y_[at]};
  }
  /// Area vector of the face from a to b, to the right of the way.
  template <class T>
  MORTISE_INLINE static Vector<T> edge(const Vector<T>& a, const Vector<T>& b) {
    return {b.y - a.y, a.x - b.x};
  }
  MORTISE_INLINE Vector<Pack> load_vector(const double* p) const { return {load(p), load(p + stride_)}; }
  MORTISE_INLINE void store_vector(double* p, const Vector<Pack>& v) const {
    store(p, v.x);
    store(p + stride_, v.y);
  }
  double* wests(int r) const { return rows_ + (r & 1) * 2 * stride_; }
  double* souths(int r) const { return rows_ + (4 + (r & 1) * 2) * stride_; }
  double* inverses(int r) const { return rows_ + (8 + (r & 1)) * stride_; }

  const double *x_, *y_;
  std::ptrdiff_t pitch_;
  double dt_;
  double* rows_;
  std::ptrdiff_t stride_;
};

}  // namespace mortise::elastic
