// The two first-order systems of elastic_step.hpp, as pure formulas over double or Pack: half step, Riemann problem at
// a face, update, wave speed. N is the unit normal of a face, towards increasing index.
#pragma once

#include "mortise/solid/cell_state.hpp"
#include "mortise/solid/elastic_step.hpp"
#include "mortise/solid/laws.hpp"

namespace mortise::elastic {

/// ρ v_t = div σ, σ_t = C : ∇v.
class Linear {
 public:
  template <class T>
  using StateOf = State<SymmetricTensor<T>, T>;
  template <class T>
  using ChangeOf = StateOf<T>;  // (Σ t, Σ v ⊗ S as strain)
  /// Traction and velocity at a face.
  template <class T>
  struct FluxOf {
    Vector<T> traction, velocity;
  };
  template <class T>
  using HalfChangeOf = Nothing;
  static constexpr int numbers = 5, flux_numbers = 4, half_change_numbers = 0;

  explicit Linear(const ElasticOptions& o)
      : lambda_(o.material.lambda),
        mu_(o.material.mu),
        inverse_density_(1 / o.material.density),
        speed_(o.material.pressure_wave_speed()),
        z_s_(o.material.density * o.material.shear_wave_speed()),
        z_p_(o.material.density * speed_) {}

  template <class T>
  MORTISE_INLINE static StateOf<T> at_rest() {
    return StateOf<T>{};
  }
  template <class T, class Normal>
  MORTISE_INLINE Vector<T> traction(const StateOf<T>& W, const Normal& N) const {
    return times(W.deformation, N);
  }
  template <class T, class Metrics>
  MORTISE_INLINE StateOf<T> half_step(const StateOf<T>& W, const Slopes<StateOf<T>>& h, const Metrics& m) const {
    return updated(W, {m.factor_xi * times(h.xi.deformation, m.xi) + m.factor_eta * times(h.eta.deformation, m.eta),
                       m.factor_xi * strain(h.xi.velocity, m.xi) + m.factor_eta * strain(h.eta.velocity, m.eta)});
  }
  /// A rotation leaves no trace in the stress: not known.
  template <class T>
  MORTISE_INLINE static Vector<T> stretched(const StateOf<T>&, const Vector<T>&) {
    return {T{}, T{}};
  }
  /// Any face state is admissible.
  template <class T>
  MORTISE_INLINE void ensure_admissible_faces(const StateOf<T>&, StateOf<T>&, Slopes<StateOf<T>>&) const {}

  template <class T>
  MORTISE_INLINE static Nothing half_change(const StateOf<T>&, const StateOf<T>&) {
    return {};
  }
  template <class T, class Normal>
  MORTISE_INLINE FluxOf<T> face(const StateOf<T>& L, const StateOf<T>& R, Nothing, const Normal& N) const {
    const Vector<T> tl = traction(L, N), tr = traction(R, N), dv = R.velocity - L.velocity, dt = tr - tl;
    const Vector<T> pull = (0.5 * z_s_) * dv + along(N, (0.5 * (z_p_ - z_s_)) * dot(dv, N));
    const Vector<T> slip = (0.5 / z_s_) * dt + along(N, (0.5 / z_p_ - 0.5 / z_s_) * dot(dt, N));
    return {0.5 * (tl + tr) + pull, 0.5 * (L.velocity + R.velocity) + slip};
  }
  template <class T, class Normal>
  MORTISE_INLINE FluxOf<T> prescribed(const Vector<T>& traction, const Vector<T>& velocity, const Normal&) const {
    return {traction, velocity};
  }
  template <class T>
  MORTISE_INLINE static FluxOf<T> scaled(T area, const FluxOf<T>& f) {
    return {area * f.traction, f.velocity};  // the velocity meets the area vector in gain()
  }
  template <class T>
  MORTISE_INLINE static FluxOf<T> difference(const FluxOf<T>& a, const FluxOf<T>& b) {
    return {a.traction - b.traction, a.velocity - b.velocity};
  }
  /// What a face of area vector S gives to the cell before it.
  template <class T, class Area>
  MORTISE_INLINE static ChangeOf<T> gain(const FluxOf<T>& f, const Area& S) {
    return {f.traction, strain(f.velocity, S)};
  }
  template <class T>
  MORTISE_INLINE StateOf<T> updated(const StateOf<T>& W, const ChangeOf<T>& gain) const {
    const SymmetricTensor<T>& e = gain.deformation;
    const T trace = lambda_ * (e.xx + e.yy);
    return {W.velocity + inverse_density_ * gain.velocity,
            W.deformation + SymmetricTensor<T>{trace + (2 * mu_) * e.xx, mu_ * e.xy, trace + (2 * mu_) * e.yy}};
  }
  /// Z⁻¹ v
  template <class T>
  MORTISE_INLINE Vector<T> admit(const StateOf<T>&, const Vector<T>& N, const Vector<T>& t) const {
    return (1 / z_s_) * t + ((1 / z_p_ - 1 / z_s_) * dot(t, N)) * N;
  }
  template <class T>
  MORTISE_INLINE static T jacobian(const StateOf<T>&) {
    return T{} + 1.0;
  }
  /// Σ_d factor_d c_p |S_d|
  template <class T, class Metrics>
  MORTISE_INLINE T wave_rate(const StateOf<T>&, const Metrics& m) const {
    return speed_ * (m.factor_xi * length(m.xi) + m.factor_eta * length(m.eta));
  }

 private:
  template <class T>
  MORTISE_INLINE static Vector<T> along(Axis<0>, T x) {
    return {x, T{}};
  }
  template <class T>
  MORTISE_INLINE static Vector<T> along(Axis<1>, T y) {
    return {T{}, y};
  }
  template <class T>
  MORTISE_INLINE static Vector<T> along(const Vector<T>& N, T s) {
    return s * N;
  }
  double lambda_, mu_, inverse_density_;
  double speed_, z_s_, z_p_;  // c_p, ρc_s, ρc_p
};

/// ρ0 v_t = Div P(F), F_t = ∇_X v.
template <class Law>
class Hyperelastic {
 public:
  template <class T>
  using StateOf = State<Tensor<T>, T>;
  template <class T>
  using ChangeOf = StateOf<T>;
  /// Gains of ρ0 v and F from a face.
  template <class T>
  using FluxOf = StateOf<T>;
  template <class T>
  using HalfChangeOf = Tensor<T>;
  static constexpr int numbers = 6, flux_numbers = 6, half_change_numbers = 4;

  explicit Hyperelastic(const ElasticOptions& o)
      : law_{o.material.density, o.material.lambda, o.material.mu},
        inverse_density_(1 / o.material.density),
        upwinding_(0.5 * o.null_mode_upwinding) {}

  template <class T>
  MORTISE_INLINE static StateOf<T> at_rest() {
    return {Vector<T>{T{}, T{}}, Tensor<T>{T{} + 1.0, T{}, T{}, T{} + 1.0}};
  }
  template <class T, class Normal>
  MORTISE_INLINE Vector<T> traction(const StateOf<T>& W, const Normal& N) const {
    return times(law_.stress(law_.at(W.deformation), W.deformation), N);
  }
  template <class T, class Metrics>
  MORTISE_INLINE StateOf<T> half_step(const StateOf<T>& W, const Slopes<StateOf<T>>& h, const Metrics& m) const {
    const Tensor<T>& F = W.deformation;
    const auto at = law_.at(F);
    return updated(W, {m.factor_xi * law_.traction_change(at, F, h.xi.deformation, m.xi) +
                           m.factor_eta * law_.traction_change(at, F, h.eta.deformation, m.eta),
                       m.factor_xi * outer(h.xi.velocity, m.xi) + m.factor_eta * outer(h.eta.velocity, m.eta)});
  }
  /// F M for a unit vector M of the reference frame.
  template <class T>
  MORTISE_INLINE static Vector<T> stretched(const StateOf<T>& W, const Vector<T>& M) {
    return times(W.deformation, M);
  }
  /// Where J of a face state would fall below a tenth of the cell's, all of them are the cell average.
  template <class T>
  MORTISE_INLINE void ensure_admissible_faces(const StateOf<T>& W, StateOf<T>& half, Slopes<StateOf<T>>& h) const {
    const Tensor<T>& F = half.deformation;
    const T lowest_xi = min(determinant(F - h.xi.deformation), determinant(F + h.xi.deformation));
    const T lowest_eta = min(determinant(F - h.eta.deformation), determinant(F + h.eta.deformation));
    const T margin = min(lowest_xi, lowest_eta) - 0.1 * determinant(W.deformation);
    if (all_positive(margin)) return;
    const auto good = margin > 0;
    half = choose(good, half, W);
    h.xi = choose(good, h.xi, StateOf<T>{});
    h.eta = choose(good, h.eta, StateOf<T>{});
  }

  /// What the half step did to F.
  template <class T>
  MORTISE_INLINE static Tensor<T> half_change(const StateOf<T>& W, const StateOf<T>& half) {
    return half.deformation - W.deformation;
  }
  /// half_change: its jump.
  template <class T, class Normal>
  MORTISE_INLINE FluxOf<T> face(const StateOf<T>& L, const StateOf<T>& R, const Tensor<T>& half_change,
                                const Normal& N) const {
    const Tensor<T>&FL = L.deformation, &FR = R.deformation, F = 0.5 * (FL + FR), jump = (FR - FL) - half_change;
    const auto left = law_.at(FL), right = law_.at(FR), mean = Law::mean(left, right, F);
    const Vector<T> tl = times(law_.stress(left, FL), N), tr = times(law_.stress(right, FR), N);
    const auto Z = law_.impedance(mean, F, N);
    const Vector<T> velocity = 0.5 * ((L.velocity + R.velocity) + Z.solve(tr - tl));
    const Vector<T> carried = law_.density * Z.solve(Z.solve(law_.traction_change(mean, F, jump, N)));
    return {0.5 * ((tl + tr) + Z.apply(R.velocity - L.velocity)),
            outer(velocity, N) + (upwinding_ * Z.speed) * (jump - outer(carried, N))};
  }
  template <class T, class Normal>
  MORTISE_INLINE FluxOf<T> prescribed(const Vector<T>& traction, const Vector<T>& velocity, const Normal& N) const {
    return {traction, outer(velocity, N)};
  }
  template <class T>
  MORTISE_INLINE static FluxOf<T> scaled(T area, const FluxOf<T>& f) {
    return {area * f.velocity, area * f.deformation};
  }
  template <class T>
  MORTISE_INLINE static FluxOf<T> difference(const FluxOf<T>& a, const FluxOf<T>& b) {
    return a - b;
  }
  template <class T, class Area>
  MORTISE_INLINE static ChangeOf<T> gain(const FluxOf<T>& f, const Area&) {
    return f;
  }
  template <class T>
  MORTISE_INLINE StateOf<T> updated(const StateOf<T>& W, const ChangeOf<T>& gain) const {
    return {W.velocity + inverse_density_ * gain.velocity, W.deformation + gain.deformation};
  }
  template <class T>
  MORTISE_INLINE Vector<T> admit(const StateOf<T>& W, const Vector<T>& N, const Vector<T>& t) const {
    return law_.impedance(law_.at(W.deformation), W.deformation, N).solve(t);
  }
  template <class T>
  MORTISE_INLINE static T jacobian(const StateOf<T>& W) {
    return determinant(W.deformation);
  }
  template <class T, class Metrics>
  MORTISE_INLINE T wave_rate(const StateOf<T>& W, const Metrics& m) const {
    const auto at = law_.at(W.deformation);
    return m.factor_xi * sqrt(law_.speed2(at, W.deformation, m.xi)) +
           m.factor_eta * sqrt(law_.speed2(at, W.deformation, m.eta));
  }

 private:
  Law law_;
  double inverse_density_, upwinding_;  // 1/ρ0, k/2
};

}  // namespace mortise::elastic
