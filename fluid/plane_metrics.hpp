// Metrics of plane quadrilateral cells whose nodes move on straight lines during a step: x(t) = x½ + (t − t½) w.
// The area vector of the straight face from node a to node b, S = (y_b − y_a, x_a − x_b) at half time, points to the
// right of the way from a to b; the face sweeps the area ½(w_a + w_b)·S per unit time. The cell area is quadratic in
// time, so that the midpoint rule is exact,
//   V' − V = Δt Σ_outward ½(w_a + w_b)·S,
// which is the geometric conservation law: uniform flow stays uniform to round-off on any moving grid.
#pragma once

#include <array>

#include "mortise/fluid/face.hpp"
#include "mortise/fluid/reconstruction.hpp"

namespace mortise {

template <class T>
struct MovingNode {
  T x, y;    // position at half time
  T wx, wy;  // velocity
};

template <class T>
struct MovingEdge {
  T sx, sy;  // area vector S at half time
  T swept;   // area per unit time, w·S
};

template <class T>
MORTISE_INLINE MovingEdge<T> edge_between(const MovingNode<T>& a, const MovingNode<T>& b) {
  MovingEdge<T> edge;
  edge.sx = b.y - a.y;
  edge.sy = a.x - b.x;
  edge.swept = 0.5 * ((a.wx + b.wx) * edge.sx + (a.wy + b.wy) * edge.sy);
  return edge;
}

/// The four nodes of a cell.
template <class T>
struct MovingCell {
  MovingNode<T> sw, se, nw, ne;

  // Area vectors point towards increasing index: west and east to +i, south and north to +j.
  MORTISE_INLINE MovingEdge<T> west() const { return edge_between(sw, nw); }
  MORTISE_INLINE MovingEdge<T> east() const { return edge_between(se, ne); }
  MORTISE_INLINE MovingEdge<T> south() const { return edge_between(se, sw); }
  MORTISE_INLINE MovingEdge<T> north() const { return edge_between(ne, nw); }

  /// The cell a time later.
  MORTISE_INLINE MovingCell after(double time) const {
    return {moved(sw, time), moved(se, time), moved(nw, time), moved(ne, time)};
  }
  MORTISE_INLINE static MovingNode<T> moved(const MovingNode<T>& n, double time) {
    return {n.x + time * n.wx, n.y + time * n.wy, n.wx, n.wy};
  }

  /// Area at t½ + shift, by the shoelace formula: half the cross product of the diagonals.
  MORTISE_INLINE T area(double shift) const {
    const T ax = (ne.x - sw.x) + shift * (ne.wx - sw.wx), ay = (ne.y - sw.y) + shift * (ne.wy - sw.wy);
    const T bx = (nw.x - se.x) + shift * (nw.wx - se.wx), by = (nw.y - se.y) + shift * (nw.wy - se.wy);
    return 0.5 * (ax * by - ay * bx);
  }
};

/// Sum over two opposite faces.
template <class T>
MORTISE_INLINE MovingEdge<T> operator+(const MovingEdge<T>& a, const MovingEdge<T>& b) {
  MovingEdge<T> sum;
  sum.sx = a.sx + b.sx;
  sum.sy = a.sy + b.sy;
  sum.swept = a.swept + b.swept;
  return sum;
}

/// |S|
template <class T>
MORTISE_INLINE T length(const MovingEdge<T>& edge) {
  return sqrt(edge.sx * edge.sx + edge.sy * edge.sy);
}

/// (u − w)·S
template <class T>
MORTISE_INLINE T relative_speed(const std::array<T, 2>& u, const MovingEdge<T>& edge) {
  return (u[0] * edge.sx + u[1] * edge.sy) - edge.swept;
}

/// Terms of the Hancock half step (reconstruction.hpp). xi, eta: sums over the opposite faces, whose mean enters;
/// factor: ½ Δt/V.
template <class T>
MORTISE_INLINE HalfStepTerms<2, T> curvilinear_terms(const Primitive<2, T>& W, const HalfSlopes<2, T>& h,
                                                     const MovingEdge<T>& xi, const MovingEdge<T>& eta, T factor) {
  HalfStepTerms<2, T> terms;
  terms.speed[0] = factor * relative_speed(W.velocity, xi);
  terms.speed[1] = factor * relative_speed(W.velocity, eta);
  terms.divergence = factor * ((h[0].velocity[0] * xi.sx + h[0].velocity[1] * xi.sy) +
                               (h[1].velocity[0] * eta.sx + h[1].velocity[1] * eta.sy));
  terms.force[0] = factor * (h[0].pressure * xi.sx + h[1].pressure * eta.sx);
  terms.force[1] = factor * (h[0].pressure * xi.sy + h[1].pressure * eta.sy);
  return terms;
}

}  // namespace mortise
