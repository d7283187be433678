// Neo-Hookean solids in an incompressible flow, by their reference maps (body_map.hpp): one velocity for both,
//   σ = s (τ + τ_contact) + (s η + (1 − Σ s) μ_f) (∇v + ∇vᵀ),   τ = G (b − ⅓ (tr b + 1) I),  b = F Fᵀ/det F,
//   ρ = (1 − Σ s) ρ_f + Σ s ρ_s,
// plane strain; for the s of shear and of viscosity see solid_edges.cpp (Rycroft, Wu, Yu & Kamrin, Journal of Fluid
// Mechanics 898, A9, 2020). Maps and velocities are staggered in time, as in reference_map_scene.hpp, so that elastic
// waves need no viscosity to be stable. What is as short as the cells is damped as by the upwinding of a Riemann
// problem: by part of the impedance times the jump of linearly reconstructed velocities, a third difference, which is
// nothing for smooth motion and for rigid rotation, and does not limit Δt.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mortise/coupler/reference_map/body_map.hpp"
#include "mortise/coupler/reference_map/solids.hpp"

namespace mortise {

/// Material within about `radius` of `center` (reference position, the edge as blurred as a surface) is held, by
/// springs and dampers as stiff as the step allows, where the motion takes it: x = center + shift(t) + R(angle(t)) (ξ −
/// center).
struct Anchor {
  Point<2> center = Point<2>::Zero();
  double radius = 0;
  std::function<Point<2>(double t)> shift;  // empty: none
  std::function<double(double t)> angle;    // radians; empty: 0
};

/// A solid. Non-dimensional.
struct FlowBody {
  std::string name;
  double density = 1, shear_modulus = 1;                 // ρ_s > 0, G > 0
  double viscosity = 0;                                  // η ≥ 0 of the material: stress η (∇v + ∇vᵀ)
  std::shared_ptr<const LevelSet> level_set;             // of its outline in the reference frame
  std::function<Point<2>(const Point<2>& x)> reference;  // ξ at t = 0; empty: undeformed
  // Stretch a the material tends to along an axis of the reference frame, 1/a across: F ← F F_a⁻¹. Empty: passive.
  std::function<double(const Point<2>& X, double t)> actuation;
  double axis = 0;  // of the actuation: radians from +x
  std::vector<Anchor> anchors;
};

struct FlowSolidsSetup {
  std::vector<FlowBody> bodies;
  double blur = 2;  // half width of the blur zone in cells
  // Part of half the impedance with which velocities that differ across an edge pull at each other.
  double damping = 0.05;
  double fluid_density = 1, fluid_viscosity = 0;
  std::array<bool, 4> walls{};  // west, east, south, north: sides that push bodies back within 3 blur widths
};

class FlowSolids : public Solids {
 public:
  /// `grid`: of the flow, not owned. Throws InputError for numbers out of range.
  FlowSolids(FlowSolidsSetup setup, const ComponentGrid<2>& grid);

  void begin(SolidFields& fields) override;
  void half_step(const EdgeVelocities& edges, double time, double dt, SolidFields& fields) override;
  void full_step(const Field<2>& velocity, double time, SolidFields& fields) override;
  double rate() const override;

  const FlowSolidsSetup& setup() const { return setup_; }
  const std::vector<std::unique_ptr<BodyMap>>& maps() const { return maps_; }
  std::int64_t orphans() const;
  /// The flow whose velocity moves the solids, until the first full step.
  void follow(const Field<2>& velocity) { velocity_ = &velocity; }

 private:
  void drift(bool to_half, double time);
  void write(bool half, double time, SolidFields& fields);
  void write_tile(int tile, bool half, double time, SolidFields& fields);
  bool near_side(int tile, std::size_t side, const TileWindow& window) const;
  void reset(int tile, const TileWindow& window, SolidFields& fields) const;
  void add_volume(int tile, const FlowBody& body, const TileBlock& map, const TileWindow& window,
                  SolidFields& fields) const;
  void add_anchor(int tile, const FlowBody& body, const Anchor& anchor, double time, const TileBlock& map,
                  const TileWindow& window, SolidFields& fields) const;

  FlowSolidsSetup setup_;
  const ComponentGrid<2>& grid_;
  std::vector<std::unique_ptr<BodyMap>> maps_;
  const Field<2>* velocity_ = nullptr;  // of the flow, at the last full step
  double last_step_ = 0, fastest_ = 0;
  std::vector<TileWindow> written_;  // per tile: where fields hold something of solids
};

}  // namespace mortise
