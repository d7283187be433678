// What the coupler knows of the two sides of a deforming interface in the plane, and nothing more: half-time data at the
// faces of either side, and who shares which face. Neither the fluid's nor the solid's code is seen from here; any
// solver that can fill these structures can be coupled.
//
// The interface is a curve with a material parameter s (reference arc length). The structure's faces divide it at their
// nodes, the fluid's faces at theirs; the two divisions need not match. Non-dimensional.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mortise/coupler/wall_law.hpp"
#include "mortise/grids/core/types.hpp"

namespace mortise {

/// The structure at one of its faces at some instant.
struct StructureTrace {
  Point<2> velocity = Point<2>::Zero();     // v_s
  Point<2> traction = Point<2>::Zero();     // t_s on the outward reference normal (into the fluid), per reference area
  Eigen::Matrix2d admittance = Eigen::Matrix2d::Zero();  // Z⁻¹: v_I = v_s + Z⁻¹(t_I − t_s); may be zero (rigid)
  Point<2> tangent = Point<2>::Zero();  // of the deformed face, per unit reference length, in the order of the faces; zero: unknown
};

/// The fluid at one of its faces at some instant.
struct FluidTrace {
  double density = 0;
  Point<2> velocity = Point<2>::Zero();
  double pressure = 0;  // p̃ = p + p∞ > 0
};

/// The division of the interface by both sides: conservative transfer over their common refinement.
class Transfer {
 public:
  struct Piece {
    int structure = 0, fluid = 0;  // faces
    double of_structure = 0;       // share of the structure face's reference length that the piece is
    double of_fluid = 0;           // share of the fluid face's
  };
  /// Parameters s of the nodes of either side in the order of its faces (one more than faces), monotone, either way;
  /// both cover the same range of length `range` (periodic: nodes may start anywhere, modulo range).
  Transfer(std::span<const double> structure_nodes, std::span<const double> fluid_nodes, bool periodic);

  const std::vector<Piece>& pieces() const { return pieces_; }
  bool matching() const { return matching_; }  // one piece per face
  int structure_faces() const { return structure_faces_; }
  int fluid_faces() const { return fluid_faces_; }

 private:
  std::vector<Piece> pieces_;
  int structure_faces_ = 0, fluid_faces_ = 0;
  bool matching_ = false;
};

/// A deformable solver on the structure's side. The interface's nodes are material points of it.
class Structure {
 public:
  virtual ~Structure() = default;
  /// Reference positions of the interface's nodes in the order of the faces; periodic: one per face, else one more.
  /// Faces run so that the structure lies on the left: the outward normal of an edge E is (E_y, −E_x)/|E|.
  virtual std::vector<Point<2>> interface_nodes() const = 0;
  /// A closed curve, or one that repeats itself: node n + faces is node n + period().
  virtual bool periodic() const = 0;
  virtual Point<2> period() const { return Point<2>::Zero(); }
  /// Δt ≤ CFL / rate.
  virtual double rate() const = 0;
  /// At t + θΔt, per face, linear in time from t to what a step of Δt has at its half; the same on every rank. Collective.
  virtual std::vector<StructureTrace> traces(double dt, double theta) = 0;
  /// Advances by dt with traction (outward reference normal, per reference area) and velocity at the faces; the new
  /// state is kept aside until commit(). False: not admissible. Collective.
  virtual bool step(std::span<const Point<2>> traction, std::span<const Point<2>> velocity, double dt) = 0;
  virtual void commit(double time) = 0;
  virtual std::string first_bad_cell() const = 0;
  /// Remembers the present state, and goes back to it: what several steps within one of the fluid's need.
  virtual bool can_return() const { return false; }
  virtual void remember() {}
  virtual void go_back() {}
};

}  // namespace mortise
