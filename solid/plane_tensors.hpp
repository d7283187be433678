// Vectors and tensors of the plane over double or Pack, and unit vectors along an axis that cost nothing.
#pragma once

#include "mortise/grids/core/simd.hpp"

namespace mortise::elastic {

template <class T>
struct Vector {
  T x, y;
};
/// The unit vector e_d.
template <int d>
struct Axis {};

/// Rows: space; columns: reference.
template <class T>
struct Tensor {
  T xx, xy, yx, yy;
};
/// xy = yx
template <class T>
struct SymmetricTensor {
  T xx, xy, yy;
};

template <class T>
MORTISE_INLINE Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class T>
MORTISE_INLINE Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class S, class T>
MORTISE_INLINE Vector<T> operator*(S s, const Vector<T>& a) {
  return {s * a.x, s * a.y};
}
template <class T>
MORTISE_INLINE Tensor<T> operator+(const Tensor<T>& a, const Tensor<T>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy};
}
template <class T>
MORTISE_INLINE Tensor<T> operator-(const Tensor<T>& a, const Tensor<T>& b) {
  return {a.xx - b.xx, a.xy - b.xy, a.yx - b.yx, a.yy - b.yy};
}
template <class S, class T>
MORTISE_INLINE Tensor<T> operator*(S s, const Tensor<T>& a) {
  return {s * a.xx, s * a.xy, s * a.yx, s * a.yy};
}
template <class T>
MORTISE_INLINE SymmetricTensor<T> operator+(const SymmetricTensor<T>& a, const SymmetricTensor<T>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
template <class T>
MORTISE_INLINE SymmetricTensor<T> operator-(const SymmetricTensor<T>& a, const SymmetricTensor<T>& b) {
  return {a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}
template <class S, class T>
MORTISE_INLINE SymmetricTensor<T> operator*(S s, const SymmetricTensor<T>& a) {
  return {s * a.xx, s * a.xy, s * a.yy};
}

template <class T>
MORTISE_INLINE T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class T>
MORTISE_INLINE T dot(const Vector<T>& a, Axis<0>) {
  return a.x;
}
template <class T>
MORTISE_INLINE T dot(const Vector<T>& a, Axis<1>) {
  return a.y;
}
template <class T>
MORTISE_INLINE T dot(const Tensor<T>& a, const Tensor<T>& b) {
  return (a.xx * b.xx + a.yy * b.yy) + (a.xy * b.xy + a.yx * b.yx);
}

/// |S|²
template <class T>
MORTISE_INLINE T length2(const Vector<T>& S) {
  return dot(S, S);
}
template <int d>
MORTISE_INLINE double length2(Axis<d>) {
  return 1;
}
template <class T>
MORTISE_INLINE T length(const Vector<T>& S) {
  return sqrt(dot(S, S));
}
template <int d>
MORTISE_INLINE double length(Axis<d>) {
  return 1;
}

// A S
template <class T>
MORTISE_INLINE Vector<T> times(const Tensor<T>& A, const Vector<T>& S) {
  return {A.xx * S.x + A.xy * S.y, A.yx * S.x + A.yy * S.y};
}
template <class T>
MORTISE_INLINE Vector<T> times(const Tensor<T>& A, Axis<0>) {
  return {A.xx, A.yx};
}
template <class T>
MORTISE_INLINE Vector<T> times(const Tensor<T>& A, Axis<1>) {
  return {A.xy, A.yy};
}
template <class T, class S>
MORTISE_INLINE Vector<T> times(const SymmetricTensor<T>& A, const S& s) {
  return times(Tensor<T>{A.xx, A.xy, A.xy, A.yy}, s);
}

/// Aᵀ s
template <class T>
MORTISE_INLINE Vector<T> transposed_times(const Tensor<T>& A, const Vector<T>& s) {
  return {A.xx * s.x + A.yx * s.y, A.xy * s.x + A.yy * s.y};
}

// v ⊗ S
template <class T>
MORTISE_INLINE Tensor<T> outer(const Vector<T>& v, const Vector<T>& S) {
  return {v.x * S.x, v.x * S.y, v.y * S.x, v.y * S.y};
}
template <class T>
MORTISE_INLINE Tensor<T> outer(const Vector<T>& v, Axis<0>) {
  return {v.x, T{}, v.y, T{}};
}
template <class T>
MORTISE_INLINE Tensor<T> outer(const Vector<T>& v, Axis<1>) {
  return {T{}, v.x, T{}, v.y};
}

/// v ⊗ S + S ⊗ v, halved on the diagonal: (ε_xx, 2ε_xy, ε_yy).
template <class T, class S>
MORTISE_INLINE SymmetricTensor<T> strain(const Vector<T>& v, const S& s) {
  const Tensor<T> A = outer(v, s);
  return {A.xx, A.xy + A.yx, A.yy};
}

template <class T>
MORTISE_INLINE T determinant(const Tensor<T>& A) {
  return A.xx * A.yy - A.xy * A.yx;
}
/// Cofactors: cof A = det A A⁻ᵀ; linear in A.
template <class T>
MORTISE_INLINE Tensor<T> cofactors(const Tensor<T>& A) {
  return {A.yy, -A.yx, -A.xy, A.xx};
}

}  // namespace mortise::elastic
