// The bodies of a case: shape, body-fitted grid, inertia, prescribed motion and forces.
#pragma once

#include <numbers>

#include "mortise/cases/scene/scene.hpp"

namespace mortise {

/// The outline of a plane body or solid in its own frame, as described. Throws InputError.
Outline outline_of(const ShapeDescription& shape);
/// Where a body or solid is at t = 0.
template <class Description>
Pose<2> pose_of(const Description& from) {
  return {{from.position[0], from.position[1]}, from.angle * std::numbers::pi / 180};
}
/// Cell layers of a body-fitted grid: those wished for, made even, or the default where that is 0.
int body_layers(int wished);

/// Appends body `index` of the description to the set-up, with a grid of cell size `spacing`, and to `shapes`. Throws InputError.
template <int Dim>
void add_body(const CaseDescription& description, std::size_t index, double spacing, SimulationSetup<Dim>& setup,
              std::vector<PlacedShape<Dim>>& shapes);

}  // namespace mortise
