// What the interface schemes share: the structure as a fluid face sees it, the fluid's wall law, and the scalar
// equation of the interface. With y = 1/z_e ≥ 0, z = P'(v_f), all in the direction n of the fluid face,
//   g(v) = w_p (P(v) − p_e) + w_v (v − v_e) = 0,   w_v = 1/(1 + y z),  w_p = y w_v:
// y = 0 is a rigid wall, v = v_e; y = ∞ has no inertia, P(v) = p_e. P is convex and increasing, so Newton's iterates
// come down on the root from above; a first step from near vacuum, where P' ≈ 0, may go too far up and is halved.
#pragma once

#include "mortise/coupler/schemes.hpp"

namespace mortise::schemes {

InterfaceSolution projection(const InterfaceProblem&, const InterfaceHistory&, const InterfaceOptions&);
InterfaceSolution traditional(const InterfaceProblem&, const InterfaceHistory&, const InterfaceOptions&);
InterfaceSolution traditional_subiterated(const InterfaceProblem&, const InterfaceHistory&, const InterfaceOptions&);
InterfaceSolution anti_traditional(const InterfaceProblem&, const InterfaceHistory&, const InterfaceOptions&);

/// The structure averaged over one fluid face, along its normal.
struct FaceStructure {
  double admittance = 0;  // y = 1/z_e = a n·Z⁻¹n
  double velocity = 0;    // v_e = n·v_s − n·Z⁻¹t_s
};
std::vector<FaceStructure> structure_at_fluid_faces(const InterfaceProblem& problem, const InterfaceOptions& options);

/// The fluid at one face, along its normal: P(v) by the law asked for. Throws NumericalError if it is inadmissible.
class FaceFluid {
 public:
  FaceFluid(const InterfaceProblem& problem, const InterfaceOptions& options, std::size_t face);
  WallPressure operator()(double velocity) const;
  double pressure() const { return trace_.pressure; }
  double velocity() const { return velocity_; }
  double impedance() const { return impedance_; }                     // z = P'(v_f)
  double sound_speed() const { return impedance_ / trace_.density; }  // c
  std::size_t face() const { return face_; }

 private:
  const FluidTrace& trace_;
  const WallLaw& law_;
  double velocity_ = 0, impedance_ = 0;
  bool nonlinear_ = true;
  std::size_t face_ = 0;
};

/// The root v of g for balance pressure p_e; admittance may be infinite. Throws NumericalError when there is none.
double wall_velocity(const FaceFluid& fluid, const FaceStructure& structure, double balance);

/// n·(vectors of the structure's faces) averaged over each fluid face.
std::vector<double> normal_at_fluid_faces(const InterfaceProblem& problem, std::span<const Point<2>> of_structure);

/// v_I = v_s + Z⁻¹(t_I − t_s) per structure face.
std::vector<Point<2>> structure_velocity(const InterfaceProblem& problem, std::span<const Point<2>> traction);

/// One answer (p, v per fluid face) for both sides. Where faces match, t_I − t_s in v_I is corrected along n by the
/// round-off that makes n·v_I = v: on a structure of next to no mass Z⁻¹ would blow it up.
InterfaceSolution common_answer(const InterfaceProblem& problem, const InterfaceOptions& options,
                                std::vector<double> pressure, std::span<const double> velocity);

inline Point<2> unit(const Point<2>& area) { return area / area.norm(); }

/// history[0] or 2 history[0] − history[1]; not for an empty history.
template <class Value>
std::vector<Value> predicted(const std::vector<std::vector<Value>>& history, bool lagged) {
  std::vector<Value> value = history.front();
  if (!lagged && history.size() > 1)
    for (std::size_t i = 0; i < value.size(); ++i) value[i] = 2 * history[0][i] - history[1][i];
  return value;
}

}  // namespace mortise::schemes
