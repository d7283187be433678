// Modified Bessel functions of the second kind with complex argument.
#pragma once

#include <complex>

namespace mortise {

/// e^z K_n(z) for n ≥ 0 and Re z > 0, relative accuracy about 1e-13:
///   e^z K_n(z) = √(π/2z)/Γ(n+½) ∫_{−∞}^{∞} exp(−x²) x^{2n} (1 + x²/2z)^{n−½} dx   (Abramowitz & Stegun 9.6.23, t = x²)
/// by the trapezoidal rule, which converges exponentially for this integrand.
std::complex<double> scaled_bessel_k(int n, std::complex<double> z);

}  // namespace mortise
