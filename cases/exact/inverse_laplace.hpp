// Numerical inverse of a Laplace transform.
#pragma once

#include <complex>
#include <functional>

namespace mortise {

/// f(t), t > 0, of F(s) = ∫_0^∞ e^{−st} f(t) dt: Fourier series on the line Re s = M ln 10/(3t) with Euler summation,
///   f(t) ≈ 10^{M/3}/t Σ_{k=0}^{2M} (−1)^k ξ_k Re F((M ln 10/3 + iπk)/t),  M = 15,
/// for f smooth at t and F regular for Re s > 0. Source: Abate & Whitt, INFORMS J. Computing 18 (2006) 408, section 5.
double inverse_laplace(const std::function<std::complex<double>(std::complex<double>)>& transform, double t);

}  // namespace mortise
