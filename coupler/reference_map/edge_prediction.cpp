#include "mortise/coupler/reference_map/edge_prediction.hpp"

#include "mortise/coupler/reference_map/edge_states.hpp"
#include "mortise/grids/core/row_workspace.hpp"

namespace mortise {
namespace {

template <class T>
MORTISE_INLINE T get(const double* p) {
  if constexpr (lanes<T> == 1)
    return *p;
  else
    return load(p);
}

/// The state at an edge of the domain; `inside` is that of the cell there, n the component along the normal.
EdgeState<double> at_boundary(const TileSide& side, std::size_t n, int place, const EdgeState<double>& inside) {
  if (velocity_given(side.kind)) return {side.velocity[n][place], side.velocity[1 - n][place]};
  if (side.kind == SideKind::slip_wall) return {0.0, inside.tangential};
  return inside;
}

class EdgeKernel {
 public:
  EdgeKernel(const EdgeTile& tile, double dt, const std::array<double, 2>& courant)
      : tile_(tile),
        nx_(tile.shape->cells[0]),
        ny_(tile.shape->cells[1]),
        stride_(tile.shape->stride),
        plane_(static_cast<std::ptrdiff_t>(tile.shape->plane)),
        half_dt_(0.5 * dt),
        cx_(courant[0]),
        cy_(courant[1]),
        work_(nx_, row_count) {}

  void run() {
    for (int r = -1; r <= ny_; ++r) {
      hat_x(*this, r);
      if (r < ny_) hat_y(*this, r + 1);
      if (r >= 0 && r < ny_) {
        x_states(*this, r);
        x_edges(*this, r);
      }
      y_states(*this, r);
      if (r >= 0) y_edges(*this, r);
    }
  }

 private:
  // Rows of the workspace, two components each; what comes in pairs is indexed by the parity of the tile's row.
  enum Row { hats_x = 0, hats_y = 2, norths = 6, souths = 10, wests = 12, easts = 14, row_count = 16 };
  double* row(int k) const { return work_.row(k); }
  double* pair(Row first, int r) const { return work_.row(first + 2 * (r & 1)); }
  std::ptrdiff_t at(int i, int j) const { return static_cast<std::ptrdiff_t>(tile_.shape->at(i, j)); }

  /// States of the cell at offset o towards its east (low side of the next edge) and west (high side of its own).
  template <class T>
  MORTISE_INLINE EdgeState<T> hat_east(std::ptrdiff_t o) const {
    const T u = get<T>(tile_.velocity + o), v = get<T>(tile_.velocity + plane_ + o), C = cx_ * u;
    return {ahead<T>(u, get<T>(tile_.slopes + o), C), ahead<T>(v, get<T>(tile_.slopes + plane_ + o), C)};
  }
  template <class T>
  MORTISE_INLINE EdgeState<T> hat_west(std::ptrdiff_t o) const {
    const T u = get<T>(tile_.velocity + o), v = get<T>(tile_.velocity + plane_ + o), C = cx_ * u;
    return {behind<T>(u, get<T>(tile_.slopes + o), C), behind<T>(v, get<T>(tile_.slopes + plane_ + o), C)};
  }
  template <class T>
  MORTISE_INLINE EdgeState<T> hat_north(std::ptrdiff_t o) const {
    const T u = get<T>(tile_.velocity + o), v = get<T>(tile_.velocity + plane_ + o), C = cy_ * v;
    return {ahead<T>(v, get<T>(tile_.slopes + 3 * plane_ + o), C),
            ahead<T>(u, get<T>(tile_.slopes + 2 * plane_ + o), C)};
  }
  template <class T>
  MORTISE_INLINE EdgeState<T> hat_south(std::ptrdiff_t o) const {
    const T u = get<T>(tile_.velocity + o), v = get<T>(tile_.velocity + plane_ + o), C = cy_ * v;
    return {behind<T>(v, get<T>(tile_.slopes + 3 * plane_ + o), C),
            behind<T>(u, get<T>(tile_.slopes + 2 * plane_ + o), C)};
  }

  // The loops take a copy of the kernel, so that the stores to the rows cannot change it in the compiler's eyes.

  /// Hat states on the west edges of row r.
  static void hat_x(const EdgeKernel k, int r) {
    double *const u = k.row(hats_x), *const v = k.row(hats_x + 1);
    const std::ptrdiff_t o = k.at(0, r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const EdgeState<Pack> e = upwind<Pack>(k.hat_east<Pack>(o + i - 1), k.hat_west<Pack>(o + i));
      store(u + i, e.normal);
      store(v + i, e.tangential);
    }
    const int place = r < 0 ? 0 : r < k.ny_ ? r : k.ny_ - 1;
    const auto put = [&](std::size_t side, int i, const EdgeState<double>& inside) {
      const EdgeState<double> e = at_boundary(k.tile_.sides[side], 0, place, inside);
      u[i] = e.normal, v[i] = e.tangential;
    };
    if (k.tile_.sides[west].boundary) put(west, 0, k.hat_west<double>(o));
    if (k.tile_.sides[east].boundary) put(east, k.nx_, k.hat_east<double>(o + k.nx_ - 1));
  }

  /// Hat states on the south edges of row r.
  static void hat_y(const EdgeKernel k, int r) {
    double *const u = k.pair(hats_y, r), *const v = u + k.work_.stride();
    const std::ptrdiff_t o = k.at(0, r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const EdgeState<Pack> e = upwind<Pack>(k.hat_north<Pack>(o + i - k.stride_), k.hat_south<Pack>(o + i));
      store(u + i, e.tangential);
      store(v + i, e.normal);
    }
    const bool low = r == 0 && k.tile_.sides[south].boundary, high = r == k.ny_ && k.tile_.sides[north].boundary;
    if (!low && !high) return;
    for (int i = -1; i <= k.nx_; ++i) {
      const EdgeState<double> inside = low ? k.hat_south<double>(o + i) : k.hat_north<double>(o + i - k.stride_);
      const EdgeState<double> e = at_boundary(k.tile_.sides[low ? south : north], 1, i, inside);
      u[i] = e.tangential, v[i] = e.normal;
    }
  }

  /// Full states of row r's cells towards west and east.
  static void x_states(const EdgeKernel k, int r) {
    const std::size_t s = k.work_.stride();
    const double *const low = k.pair(hats_y, r), *const high = k.pair(hats_y, r + 1);
    double *const W = k.row(wests), *const E = k.row(easts);
    const std::ptrdiff_t o = k.at(0, r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const Pack u = load(k.tile_.velocity + o + i), v = load(k.tile_.velocity + k.plane_ + o + i), C = k.cx_ * u;
      const Pack c = (0.25 * k.cy_) * (load(high + s + i) + load(low + s + i));
      const Pack du = load(k.tile_.slopes + o + i), dv = load(k.tile_.slopes + k.plane_ + o + i);
      const Pack gain_u = k.half_dt_ * load(k.tile_.acceleration + o + i) - c * (load(high + i) - load(low + i));
      const Pack gain_v =
          k.half_dt_ * load(k.tile_.acceleration + k.plane_ + o + i) - c * (load(high + s + i) - load(low + s + i));
      store(E + i, ahead<Pack>(u, du, C) + gain_u);
      store(E + s + i, ahead<Pack>(v, dv, C) + gain_v);
      store(W + i, behind<Pack>(u, du, C) + gain_u);
      store(W + s + i, behind<Pack>(v, dv, C) + gain_v);
    }
  }

  static void x_edges(const EdgeKernel k, int r) {
    const std::size_t s = k.work_.stride();
    const double *const W = k.row(wests), *const E = k.row(easts);
    double *const u = k.tile_.x_edges + k.at(0, r), *const v = u + k.plane_;
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const EdgeState<Pack> e = upwind<Pack>({load(E + i - 1), load(E + s + i - 1)}, {load(W + i), load(W + s + i)});
      store(u + i, e.normal);
      store(v + i, e.tangential);
    }
    const auto put = [&](std::size_t side, int i, const EdgeState<double>& inside) {
      const EdgeState<double> e = at_boundary(k.tile_.sides[side], 0, r, inside);
      u[i] = e.normal, v[i] = e.tangential;
    };
    if (k.tile_.sides[west].boundary) put(west, 0, {W[0], W[s]});
    if (k.tile_.sides[east].boundary) put(east, k.nx_, {E[k.nx_ - 1], E[s + static_cast<std::size_t>(k.nx_) - 1]});
  }

  /// Full states of row r's cells towards south and north.
  static void y_states(const EdgeKernel k, int r) {
    const std::size_t s = k.work_.stride();
    const double* const hat = k.row(hats_x);
    double *const S = k.row(souths), *const N = k.pair(norths, r);
    const std::ptrdiff_t o = k.at(0, r);
    for (int i = row_start; i < k.nx_; i += simd_width) {
      const Pack u = load(k.tile_.velocity + o + i), v = load(k.tile_.velocity + k.plane_ + o + i), C = k.cy_ * v;
      const Pack c = (0.25 * k.cx_) * (load(hat + i + 1) + load(hat + i));
      const Pack du = load(k.tile_.slopes + 2 * k.plane_ + o + i), dv = load(k.tile_.slopes + 3 * k.plane_ + o + i);
      const Pack gain_u = k.half_dt_ * load(k.tile_.acceleration + o + i) - c * (load(hat + i + 1) - load(hat + i));
      const Pack gain_v =
          k.half_dt_ * load(k.tile_.acceleration + k.plane_ + o + i) - c * (load(hat + s + i + 1) - load(hat + s + i));
      store(N + i, ahead<Pack>(u, du, C) + gain_u);
      store(N + s + i, ahead<Pack>(v, dv, C) + gain_v);
      store(S + i, behind<Pack>(u, du, C) + gain_u);
      store(S + s + i, behind<Pack>(v, dv, C) + gain_v);
    }
  }

  static void y_edges(const EdgeKernel k, int r) {
    const std::size_t s = k.work_.stride();
    const double *const S = k.row(souths), *const N = k.pair(norths, r - 1);
    double *const u = k.tile_.y_edges + k.at(0, r), *const v = u + k.plane_;
    for (int i = row_start; i < k.nx_; i += simd_width) {
      const EdgeState<Pack> e = upwind<Pack>({load(N + s + i), load(N + i)}, {load(S + s + i), load(S + i)});
      store(u + i, e.tangential);
      store(v + i, e.normal);
    }
    const bool low = r == 0 && k.tile_.sides[south].boundary, high = r == k.ny_ && k.tile_.sides[north].boundary;
    if (!low && !high) return;
    const double* const inner = low ? S : N;
    for (int i = 0; i < k.nx_; ++i) {
      const EdgeState<double> e =
          at_boundary(k.tile_.sides[low ? south : north], 1, i, {inner[s + static_cast<std::size_t>(i)], inner[i]});
      u[i] = e.tangential, v[i] = e.normal;
    }
  }

  EdgeTile tile_;
  int nx_, ny_;
  std::ptrdiff_t stride_, plane_;
  double half_dt_, cx_, cy_;
  RowWorkspace work_;
};

}  // namespace

void predict_edges(const EdgeTile& tile, double dt, const std::array<double, 2>& courant) {
  EdgeKernel(tile, dt, courant).run();
}

}  // namespace mortise
