// Linear acoustics on one side of an interface, as the solvers of gas and solid discretise it: the MUSCL-Hancock scheme
// without limiter, seen from the interface outwards. With x the distance from the interface, u the velocity along x and
// q = p in a gas, q = −σ in a solid,
//   ρ u_t + q_x = 0,   q_t + ρc² u_x = 0,
// and in the variables a = √z u, b = q/√z, z = ρc, whose squares sum up to 2c times the energy per length,
//   a_t + c b_x = 0,   b_t + c a_x = 0.
// Central slopes; in the cell at the interface that of the parabola through the three cells next to it. Face states
// w ∓ ½δ − ½λ(δ_b, δ_a), λ = c Δt/h; upwind fluxes. Order 1: slopes zero. What happens at the interface is given.
// Linearised about gas or solid at rest without load the two solvers are this to the last term: the motion of the
// grids only enters products of small quantities, and density decouples. Non-dimensional.
#pragma once

#include <array>
#include <vector>

namespace mortise {

/// What happens at the far end of a side. The slope of the last cell is that with two ghost cells beyond it.
enum class FarEnd {
  open,   // ghosts repeat the last cell: waves leave (gas: outflow)
  rest,   // ghosts at rest: waves leave (gas, solid: exact data)
  wall,   // ghosts mirrored, u = 0 (gas: wall)
  fixed,  // ghosts continue the parabola, u = 0 (solid: fixed, slip)
  free    // ghosts continue the parabola, q = 0 (solid: free)
};

/// One side of an interface.
struct AcousticSide {
  double impedance = 1;  // z = ρc > 0
  double speed = 1;      // c > 0
  double spacing = 1;    // h > 0
  int cells = 12;        // ≥ 3
  FarEnd end = FarEnd::open;
};

/// (a, b) in a cell or at a face.
using Wave = std::array<double, 2>;

class AcousticLine {
 public:
  /// At rest. order: 1 or 2. Throws InputError naming the number of the side that is not admissible.
  explicit AcousticLine(const AcousticSide& side, int order = 2);

  std::vector<Wave>& cells() { return cells_; }  // from the interface outwards
  const std::vector<Wave>& cells() const { return cells_; }

  /// (u, q) at the interface, as this side alone has it, at t and at t + ½ dt.
  struct Trace {
    double velocity_now, stress_now, velocity, stress;
  };
  Trace trace(double dt) const;
  /// Advances by dt with these u and q at the interface.
  void step(double velocity, double stress, double dt);

 private:
  std::vector<Wave> with_ghosts() const;
  Wave slope(const std::vector<Wave>& w, std::size_t cell) const;

  AcousticSide side_;
  int order_;
  double root_;  // √z
  std::vector<Wave> cells_;
};

}  // namespace mortise
