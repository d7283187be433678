// Loads and stores of states in structure-of-arrays rows, components `plane` doubles apart.
#pragma once

#include <cstddef>

#include "mortise/solid/systems.hpp"

namespace mortise::elastic::rows {

MORTISE_INLINE void put(double* p, Pack x) { store(p, x); }
MORTISE_INLINE void put(double* p, double x) { *p = x; }
template <class T>
MORTISE_INLINE T get(const double* p) {
  if constexpr (lanes<T> == 1)
    return *p;
  else
    return load(p);
}

template <class T>
MORTISE_INLINE void read(const double* p, std::size_t plane, Vector<T>& v) {
  v = {get<T>(p), get<T>(p + plane)};
}
template <class T>
MORTISE_INLINE void read(const double* p, std::size_t plane, SymmetricTensor<T>& A) {
  A = {get<T>(p), get<T>(p + plane), get<T>(p + 2 * plane)};
}
template <class T>
MORTISE_INLINE void read(const double* p, std::size_t plane, Tensor<T>& A) {
  A = {get<T>(p), get<T>(p + plane), get<T>(p + 2 * plane), get<T>(p + 3 * plane)};
}
template <class D, class T>
MORTISE_INLINE void read(const double* p, std::size_t plane, State<D, T>& W) {
  read(p, plane, W.velocity);
  read(p + 2 * plane, plane, W.deformation);
}
template <class T>
MORTISE_INLINE void read(const double* p, std::size_t plane, Linear::FluxOf<T>& f) {
  read(p, plane, f.traction);
  read(p + 2 * plane, plane, f.velocity);
}
MORTISE_INLINE void read(const double*, std::size_t, Nothing&) {}
template <class Value>
MORTISE_INLINE Value read(const double* p, std::size_t plane) {
  Value value;
  read(p, plane, value);
  return value;
}

template <class T>
MORTISE_INLINE void write(double* p, std::size_t plane, const Vector<T>& v) {
  put(p, v.x);
  put(p + plane, v.y);
}
template <class T>
MORTISE_INLINE void write(double* p, std::size_t plane, const SymmetricTensor<T>& A) {
  put(p, A.xx);
  put(p + plane, A.xy);
  put(p + 2 * plane, A.yy);
}
template <class T>
MORTISE_INLINE void write(double* p, std::size_t plane, const Tensor<T>& A) {
  put(p, A.xx);
  put(p + plane, A.xy);
  put(p + 2 * plane, A.yx);
  put(p + 3 * plane, A.yy);
}
template <class D, class T>
MORTISE_INLINE void write(double* p, std::size_t plane, const State<D, T>& W) {
  write(p, plane, W.velocity);
  write(p + 2 * plane, plane, W.deformation);
}
template <class T>
MORTISE_INLINE void write(double* p, std::size_t plane, const Linear::FluxOf<T>& f) {
  write(p, plane, f.traction);
  write(p + 2 * plane, plane, f.velocity);
}
MORTISE_INLINE void write(double*, std::size_t, Nothing) {}

}  // namespace mortise::elastic::rows
