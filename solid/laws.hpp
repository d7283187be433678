// The hyperelastic laws of material.hpp as pure formulas over double or Pack. `at(F)` makes what the other formulas of
// a law share; `mean` is that of the two sides of a face, F their mean; N is a unit normal (Vector or Axis).
//   neo_hookean, with G = F⁻ᵀ:        P = μ (F − G) + λ ln J G,   k = μ + λ − λ ln J,
//     dP = μ dF + (λ ln J − μ)/J cof(dF) + k (G : dF) G,          Γ = μ I + k g gᵀ,  g = G N
//   saint_venant_kirchhoff:           P = F S,   dP = dF S + F dS,   dS = C : sym(Fᵀ dF)
//     Γ = (N·S N) I + (λ + μ) f fᵀ + μ F Fᵀ,  f = F N
// Where Γ is not positive definite (Saint Venant-Kirchhoff at strong compression, neo-Hookean beyond ln J = 1 + μ/λ)
// impedances are those of a Γ made so.
#pragma once

#include "mortise/grids/core/simd_log.hpp"
#include "mortise/solid/plane_tensors.hpp"

namespace mortise::elastic {

/// Z = z I + q g gᵀ and its inverse y I − p g gᵀ.
template <class T>
struct RankOneImpedance {
  T z, q, y, p;
  Vector<T> g;
  T speed;  // c_p
  MORTISE_INLINE Vector<T> apply(const Vector<T>& v) const { return z * v + (q * dot(g, v)) * g; }
  MORTISE_INLINE Vector<T> solve(const Vector<T>& t) const { return y * t - (p * dot(g, t)) * g; }
};

/// Z and Z⁻¹ by their components.
template <class T>
struct FullImpedance {
  SymmetricTensor<T> matrix, inverse;
  T speed;  // c_p
  MORTISE_INLINE Vector<T> apply(const Vector<T>& v) const { return times(matrix, v); }
  MORTISE_INLINE Vector<T> solve(const Vector<T>& t) const { return times(inverse, t); }
};

struct NeoHookean {
  double density, lambda, mu;
  double root_density = std::sqrt(density), root_mu = std::sqrt(mu);

  template <class T>
  struct Local {
    Tensor<T> G;  // F⁻ᵀ
    T inverse_j, log_j;
  };

  template <class T>
  MORTISE_INLINE Local<T> at(const Tensor<T>& F) const {
    const T J = determinant(F), inverse = 1.0 / J;
    return {inverse * cofactors(F), inverse, natural_log(J)};
  }
  template <class T>
  MORTISE_INLINE static Local<T> mean(const Local<T>& a, const Local<T>& b, const Tensor<T>& F) {
    const T inverse = 0.5 * (a.inverse_j + b.inverse_j);
    return {inverse * cofactors(F), inverse, 0.5 * (a.log_j + b.log_j)};
  }
  template <class T>
  MORTISE_INLINE Tensor<T> stress(const Local<T>& at, const Tensor<T>& F) const {
    return mu * F + (lambda * at.log_j - mu) * at.G;
  }
  /// dP S for a change dF.
  template <class T, class S>
  MORTISE_INLINE Vector<T> traction_change(const Local<T>& at, const Tensor<T>&, const Tensor<T>& dF,
                                           const S& s) const {
    const T b = lambda * at.log_j - mu;
    return (mu * times(dF, s) + (b * at.inverse_j) * times(cofactors(dF), s)) +
           ((lambda - b) * dot(at.G, dF)) * times(at.G, s);
  }
  template <class T, class S>
  MORTISE_INLINE SymmetricTensor<T> acoustic_tensor(const Local<T>& at, const Tensor<T>&, const S& N) const {
    const Vector<T> g = times(at.G, N);
    const T k = (mu + lambda) - lambda * at.log_j;
    return {mu + k * (g.x * g.x), k * (g.x * g.y), mu + k * (g.y * g.y)};
  }
  /// With e = μ + k|g|²: Z = √ρ0 (√μ I + k/(√e + √μ) g gᵀ).
  template <class T, class S>
  MORTISE_INLINE RankOneImpedance<T> impedance(const Local<T>& at, const Tensor<T>&, const S& N) const {
    const Vector<T> g = times(at.G, N);
    const T k = max((mu + lambda) - lambda * at.log_j, T{});
    const T root = sqrt(mu + k * dot(g, g));
    const T share = k / (root * (root + root_mu));
    return {T{} + root_density * root_mu,
            (root_density * root) * share,
            T{} + 1 / (root_density * root_mu),
            share * (1 / (root_density * root_mu)),
            g,
            root * (1 / root_density)};
  }
  /// (c_p |S|)², of the larger eigenvalue of Γ.
  template <class T, class S>
  MORTISE_INLINE T speed2(const Local<T>& at, const Tensor<T>&, const S& s) const {
    const Vector<T> g = times(at.G, s);
    return (mu * length2(s) + max((mu + lambda) - lambda * at.log_j, T{}) * dot(g, g)) * (1 / density);
  }
};

struct SaintVenantKirchhoff {
  double density, lambda, mu;

  template <class T>
  using Local = SymmetricTensor<T>;  // S

  template <class T>
  MORTISE_INLINE SymmetricTensor<T> second_stress(const SymmetricTensor<T>& strain) const {
    const T trace = lambda * (strain.xx + strain.yy);
    return {trace + (2 * mu) * strain.xx, (2 * mu) * strain.xy, trace + (2 * mu) * strain.yy};
  }
  template <class T>
  MORTISE_INLINE Local<T> at(const Tensor<T>& F) const {
    return second_stress(SymmetricTensor<T>{0.5 * ((F.xx * F.xx + F.yx * F.yx) - 1.0),
                                            0.5 * (F.xx * F.xy + F.yx * F.yy),
                                            0.5 * ((F.xy * F.xy + F.yy * F.yy) - 1.0)});
  }
  template <class T>
  MORTISE_INLINE static Local<T> mean(const Local<T>& a, const Local<T>& b, const Tensor<T>&) {
    return 0.5 * (a + b);
  }
  template <class T>
  MORTISE_INLINE Tensor<T> stress(const Local<T>& S, const Tensor<T>& F) const {
    return {F.xx * S.xx + F.xy * S.xy, F.xx * S.xy + F.xy * S.yy, F.yx * S.xx + F.yy * S.xy, F.yx * S.xy + F.yy * S.yy};
  }
  /// dP s for a change dF.
  template <class T, class V>
  MORTISE_INLINE Vector<T> traction_change(const Local<T>& S, const Tensor<T>& F, const Tensor<T>& dF,
                                           const V& s) const {
    const T xy = (F.xx * dF.xy + F.yx * dF.yy) + (dF.xx * F.xy + dF.yx * F.yy);
    const SymmetricTensor<T> dS =
        second_stress(SymmetricTensor<T>{F.xx * dF.xx + F.yx * dF.yx, 0.5 * xy, F.xy * dF.xy + F.yy * dF.yy});
    return times(dF, times(S, s)) + times(F, times(dS, s));
  }
  /// |N|² Γ for an N of any length.
  template <class T, class V>
  MORTISE_INLINE SymmetricTensor<T> acoustic_tensor(const Local<T>& S, const Tensor<T>& F, const V& N) const {
    const Vector<T> f = times(F, N);
    const T normal = dot(times(S, N), N);
    const auto m = mu * length2(N);
    const double k = lambda + mu;
    return {normal + k * (f.x * f.x) + m * (F.xx * F.xx + F.xy * F.xy),
            k * (f.x * f.y) + m * (F.xx * F.yx + F.xy * F.yy),
            normal + k * (f.y * f.y) + m * (F.yx * F.yx + F.yy * F.yy)};
  }
  /// √A = (A + √det A I)/√(tr A + 2 √det A); A is Γ moved up until its smaller eigenvalue is at least 0.01 μ.
  template <class T, class V>
  MORTISE_INLINE FullImpedance<T> impedance(const Local<T>& S, const Tensor<T>& F, const V& N) const {
    const SymmetricTensor<T> A = acoustic_tensor(S, F, N);
    const T middle = 0.5 * (A.xx + A.yy), spread = radius(A);
    const T lift = max(0.01 * mu - (middle - spread), T{});
    const T small = (middle - spread) + lift, top = (middle + spread) + lift;
    const T root_det = sqrt(small * top), factor = std::sqrt(density) / sqrt((small + top) + 2.0 * root_det);
    const T diagonal = root_det + lift;
    const SymmetricTensor<T> Z = {factor * (A.xx + diagonal), factor * A.xy, factor * (A.yy + diagonal)};
    const T inverse_det = 1.0 / (density * root_det);
    return {Z, {inverse_det * Z.yy, -(inverse_det * Z.xy), inverse_det * Z.xx}, sqrt(top * (1 / density))};
  }
  /// (c_p |s|)², of the larger eigenvalue of Γ.
  template <class T, class V>
  MORTISE_INLINE T speed2(const Local<T>& S, const Tensor<T>& F, const V& s) const {
    const SymmetricTensor<T> A = acoustic_tensor(S, F, s);
    return max(0.5 * (A.xx + A.yy) + radius(A), T{}) * (1 / density);
  }

 private:
  /// Half the distance of the eigenvalues.
  template <class T>
  MORTISE_INLINE static T radius(const SymmetricTensor<T>& A) {
    const T half = 0.5 * (A.xx - A.yy);
    return sqrt(half * half + A.xy * A.xy);
  }
};

}  // namespace mortise::elastic
