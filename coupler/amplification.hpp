// Theory of the coupling schemes' stability: the matrix by which one step of the whole discretisation, linearised about
// gas and solid at rest, amplifies a disturbance of an interface in one dimension,
//   x^{n+1} = A x^n,   stable iff no eigenvalue of A leaves the unit circle (beyond it by round-off).
// Both sides are the code's own scheme (acoustic_line.hpp); what happens between them is asked of the library's
// coupling schemes themselves, column by column on unit vectors: a new scheme has its theory with it.
//
// Where both far ends are open the eigenvalues are those of the sides alone, and the roots ζ of the scheme, for nothing
// of what a side sends out comes back. First-order upwind or second, any Δt, b = z_f/z_s, β = z Δt/m, z the sum of the
// impedances of all sides:
//   traditional        lagged ζ = −b, extrapolated ζ² + b (2ζ − 1) = 0      unstable iff z_s < z_f, z_s < 3 z_f
//   anti-traditional   the same with 1/b                                    unstable iff z_f < z_s, z_f < 3 z_s
//   projection         no ζ but 0
//   rigid body         traditional ζ = 1 − β: unstable iff m < z Δt/2
//                      rigid ζ = (1 − (1 − 2g) β)/(1 + g β)²,  g = 1 − 1/√2: SDIRK2's own stability function
// Far ends that reflect close the loop. Lagged velocities then work on whatever swings between the two sides, −Δt ⟨p
// v'⟩ per time: where the gas is a spring to a solid that swings as a mass, they feed it at any ratio of impedances
// (extrapolated ones Δt² times more slowly), slowly enough to be missed in a short run.
//
// Waves along the wall: pressures and tractions know the velocity of every face, but the gas's wall moves with its
// nodes, which average over faces (interface_nodes.hpp), and so misses the part 1 − α of a wave along the wall, α =
// cos⁴(θ/2) for a wave that turns by θ per face. With `following` = α the matrix is that of such a wave, up to what
// waves and dissipation along the wall do themselves. First order, lagged traditional: ζ (ζ − 1 + λ) + b (ζ − 1 + αλ) =
// 0, unstable iff z_s/z_f < (2 − αλ)/(2 − λ): in the plane, the traditional schemes fail for heavier solids than on a
// line. The projection does not. Non-dimensional. Source of the idea: stability analysis by normal modes, Gustafsson,
// Kreiss & Sundström, Math. Comp. 26 (1972) 649; applied to interfaces by Banks & Sjögreen, Commun. Comput. Phys. 10
// (2011) 279.
#pragma once

#include <string>
#include <vector>

#include "mortise/coupler/acoustic_line.hpp"
#include "mortise/grids/core/types.hpp"

namespace mortise {

/// An elastic solid beside a gas.
struct ElasticLine {
  AcousticSide solid, gas;
  double time_step = 0;               // Δt > 0 of the gas; of the solid, if the gas takes several steps within it
  std::string scheme = "projection";  // key of interface_schemes()
  bool lagged = false;                // InterfaceOptions::lagged
  int order = 2;                      // of both sides
  double following = 1;               // α: velocity of the gas's wall over that of the interface's faces
  int solid_substeps = 1;             // of the solid within one of the gas
  std::vector<double> gas_shares;     // parts of one step of the solid that the gas's steps take; empty: all of it, one
};

/// A rigid body with gas on one or both sides.
struct RigidLine {
  std::vector<AcousticSide> gases;  // one or two
  double mass = 0;                  // per area, ≥ 0
  double time_step = 0;             // Δt > 0
  std::string scheme = "rigid";     // key of body_schemes<1>()
  int order = 2;
};

/// A: square, of 2 (cells of both sides) + 4 rows. The state is (√z v, σ/√z) of the solid's cells, (√z v, p/√z) of the
/// gas's, both from the interface outwards with v positive away from it, and the wall velocities and loads of the last
/// two steps. Of one step of the slower side. Throws InputError for an unknown scheme or inadmissible numbers,
/// NumericalError where the scheme has no answer (sub-iterations that do not converge).
Eigen::MatrixXd amplification_matrix(const ElasticLine& line);
/// A: square, of 2 (cells of all sides) + 1 rows; the last is the body's velocity. Throws the same.
Eigen::MatrixXd amplification_matrix(const RigidLine& line);

/// Largest |eigenvalue| of a square matrix. Throws NumericalError if the iteration fails.
double spectral_radius(const Eigen::MatrixXd& matrix);

/// Spectral radius of A per step of the gas: the factor by which the fastest disturbance grows, in the long run.
double growth_factor(const ElasticLine& line);
double growth_factor(const RigidLine& line);

}  // namespace mortise
