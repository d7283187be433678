// A hyperelastic solid seen from space: what the gradient G = ∂ξ/∂x of its reference map says of stress, density and
// energy at a point. With b = F Fᵀ = (GᵀG)⁻¹ and J = 1/det G, for the laws of solid/material.hpp (plane strain),
//   neo_hookean            σ = (μ (b − I) + λ ln J I)/J            W = ½μ (tr b − 2) − μ ln J + ½λ ln² J
//   saint_venant_kirchhoff σ = (½λ (tr b − 2) b + μ (b² − b))/J    W = ⅛λ (tr b − 2)² + ¼μ (tr b² − 2 tr b + 2)
// (Kamrin, Rycroft & Nave, Journal of the Mechanics and Physics of Solids 60, 2012, for the reference map).
// The solid is free of stress in gas of pressure p_e: its stress is σ − p_e I and its energy per reference volume
// W − p_e J + C, where C = p_e γ/(γ − 1) makes the energy per volume that of the gas, p_e/(γ − 1), where F = I. What is
// given here is what there is beyond gas of pressure p_e: σ, and (W + C)/J − C.
#pragma once

#include "mortise/grids/core/simd_log.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// Constants of one body.
struct SolidLaw {
  double density, lambda, mu;  // ρ0, λ, μ
  double pressure;             // p̃_e
  double gamma;                // of the gas
  bool neo_hookean;
};

/// G: row k is ∇ξ_k. T is double or Pack.
template <class T>
struct MapGradient {
  T xx, xy, yx, yy;
  MORTISE_INLINE T determinant() const { return xx * yy - xy * yx; }
};

/// Per volume of space.
template <class T>
struct SolidPoint {
  T xx, xy, yy;              // σ
  T density, energy;         // ρ0/J, (W + C)/J − C
  T normal_x, tangential_x;  // ρc² of waves along x: at most, and of waves that move along y; the same along y:
  T normal_y, tangential_y;
};

/// det G > 0; elsewhere all is NaN.
template <class T>
MORTISE_INLINE SolidPoint<T> solid_point(const SolidLaw& law, const MapGradient<T>& G) {
  const T det = G.determinant(), inverse = 1.0 / (det * det);
  const T bxx = inverse * (G.xy * G.xy + G.yy * G.yy), byy = inverse * (G.xx * G.xx + G.yx * G.yx);
  const T bxy = -(inverse * (G.xx * G.xy + G.yx * G.yy));
  const T trace = bxx + byy;
  const double rest = law.pressure * (law.gamma / (law.gamma - 1));
  SolidPoint<T> p;
  p.density = law.density * det;
  if (law.neo_hookean) {
    const T log_j = -natural_log(det);
    const T own = law.lambda * log_j - law.mu;
    p.xx = det * (law.mu * bxx + own);
    p.xy = det * (law.mu * bxy);
    p.yy = det * (law.mu * byy + own);
    p.energy =
        det * ((0.5 * law.mu) * (trace - 2.0) + log_j * ((0.5 * law.lambda) * log_j - law.mu)) + rest * (det - 1.0);
    const T bulk = max((law.mu + law.lambda) - law.lambda * log_j, T{});
    p.tangential_x = det * (law.mu * bxx);
    p.tangential_y = det * (law.mu * byy);
    p.normal_x = p.tangential_x + det * bulk;
    p.normal_y = p.tangential_y + det * bulk;
    return p;
  }
  const T e = (0.5 * law.lambda) * (trace - 2.0) - law.mu;  // F S Fᵀ = e b + μ b²
  const T cxx = bxx * bxx + bxy * bxy, cxy = bxy * trace, cyy = byy * byy + bxy * bxy;
  const T sxx = e * bxx + law.mu * cxx, sxy = e * bxy + law.mu * cxy, syy = e * byy + law.mu * cyy;
  p.xx = det * sxx;
  p.xy = det * sxy;
  p.yy = det * syy;
  p.energy = det * ((0.125 * law.lambda) * ((trace - 2.0) * (trace - 2.0)) +
                    (0.25 * law.mu) * (cxx + cyy - 2.0 * trace + 2.0)) +
             rest * (det - 1.0);
  const double k = law.lambda + law.mu;
  // Γ(n) = (n·σn J) I + (λ + μ) b n ⊗ b n + μ (n·b n) b; its larger eigenvalue is at most that of its largest row sum.
  const T xx = sxx + k * (bxx * bxx) + law.mu * (bxx * bxx), xt = sxx + k * (bxy * bxy) + law.mu * (bxx * byy),
          xo = abs(bxx * bxy) * (k + law.mu);
  const T yy = syy + k * (byy * byy) + law.mu * (byy * byy), yt = syy + k * (bxy * bxy) + law.mu * (byy * bxx),
          yo = abs(byy * bxy) * (k + law.mu);
  const T floor = T{} + 0.01 * law.mu;  // compressed, the law loses ellipticity
  p.normal_x = det * max(max(xx, xt) + xo, floor);
  p.tangential_x = det * max(xt, floor);
  p.normal_y = det * max(max(yy, yt) + yo, floor);
  p.tangential_y = det * max(yt, floor);
  return p;
}

}  // namespace mortise
