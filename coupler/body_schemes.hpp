// The coupling schemes for rigid bodies, by key: what happens at the wall between t and t + Δt.
#pragma once

#include "mortise/coupler/added_mass.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {

template <int Dim>
struct BodyScheme {
  BodyMotion<Dim> (*advance)(const BodyStep<Dim>&, std::span<const WallFace<Dim>>, const WallLaw&);
  bool needs_mass = false;  // every free degree of freedom must have mass
};

/// "rigid": added mass, stable for any mass; "traditional": the explicit foil.
template <int Dim>
const Registry<BodyScheme<Dim>>& body_schemes();

}  // namespace mortise
