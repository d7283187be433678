// One step of all bodies, with contact. Two phases, after Guendelman, Bridson, Fedkiw, ACM Trans. Graph. 22 (2003) 871:
//   impact   at t: pairs that touch, or would within the step, and approach with y^n exchange impulses with restitution
//            through their own masses, as if the fluid were not there (an impact takes no time);
//   contact  during the step: constant contact forces λ/Δt ≥ 0 act on the bodies as external forces, such that nothing
//            that touches approaches with y^{n+1}; λ (v_n) = 0.
// The contact forces enter the body equations together with the fluid's, by Newton's method on y^{n+1}(λ) with the
// bodies' impulse response: the wall pressures of the step are those of the motion with contact. Changing velocities
// after the step instead leaves the fluid pressures of a free body on one that is held: for a light body pressed
// against a wall by a shock that is the incident instead of the reflected pressure.
#pragma once

#include <functional>
#include <vector>

#include "mortise/coupler/added_mass.hpp"
#include "mortise/coupler/contact.hpp"

namespace mortise {

template <int Dim>
struct CoupledBody {
  BodyStep<Dim> step;
  std::vector<WallFace<Dim>> faces;
  Point<Dim> position = Point<Dim>::Zero();  // centre of mass, of which contact points take their arms
  bool round = false;                        // a circle
};

/// advance_added_mass or advance_traditional.
template <int Dim>
using BodyAdvance = BodyMotion<Dim> (*)(const BodyStep<Dim>&, std::span<const WallFace<Dim>>, const WallLaw&);

/// Closest points of all pairs that are closer than `within` (length). Empty function: no contact.
template <int Dim>
using GapSearch = std::function<std::vector<ContactPoint<Dim>>(double within)>;

template <int Dim>
struct ContactStep {
  std::vector<BodyMotion<Dim>> motions;  // per body
  std::vector<BodyVector<Dim>> impulse;  // of all contacts on each body; with mass, M Δy = Δt (F + F_ext) + impulse
  int count = 0;                         // contacts with an impulse
  std::vector<ContactPoint<Dim>> unresolved;  // squeezed by prescribed motions: no impulse can part them
};

/// `options.dt` is taken from the bodies' steps. Deterministic. Throws what `advance` throws.
template <int Dim>
ContactStep<Dim> advance_bodies(std::vector<CoupledBody<Dim>> bodies, BodyAdvance<Dim> advance, const WallLaw& law,
                                const GapSearch<Dim>& gaps, ContactOptions options);

}  // namespace mortise
