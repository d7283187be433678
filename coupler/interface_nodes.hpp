// How the nodes of a deforming interface follow the structure, whose velocity is known at its faces.
#pragma once

#include <span>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// The nodes of an interface in its reference frame, in the order of the faces: node n + faces is node n + period.
struct InterfaceCurve {
  std::vector<Point<2>> nodes;  // periodic: one per face, else one more
  bool periodic = true;
  Point<2> period = Point<2>::Zero();

  std::size_t faces() const { return nodes.size() - (periodic ? 0 : 1); }
};

/// Velocities of the nodes: means of the four faces nearest with weights (1, 3, 3, 1)/8, the wave of two faces vanishing
/// twice; beyond open ends the velocity is extrapolated linearly.
std::vector<Point<2>> node_velocities(std::span<const Point<2>> of_faces, bool periodic);

/// What a step has to add to the displacement of each node so that wrinkles fade on the interface as they do in the
/// structure. Of third order over a time for smooth motions; open ends stay where they are.
/// displacement: of the nodes; tangents: F T per face, zero where the structure does not know it, at the same instant.
/// Where all tangents are known, rigid motions are left alone.
///
/// Upwinding lets the deformation gradient F of a solid fade at the grid scale, while nodes moved by the velocity remember
/// every wrinkle. A pressure p ≠ p_e turns with the nodes, and no stress resists where F has faded: with impedances z_p,
/// z_s of the solid, wrinkles of wave number k then grow at the rate |p − p_e| k / √(z_p z_s), whatever the densities and the
/// faster the finer the grid. (The exact surface is stable: with the pressure turning with it, a solid under uniform
/// pressure has the surface waves of a free one of moduli λ', μ' of that state.) So the edges of the interface relax to
/// F T, by `strength` of the difference per step of the structure (1/4: the wave of two faces loses all of it).
/// Where F is not known, a quarter of `strength` times the fourth difference is taken from the displacement instead.
std::vector<Point<2>> wrinkle_correction(const InterfaceCurve& curve, std::span<const Point<2>> displacement,
                                         std::span<const Point<2>> tangents, double strength);

}  // namespace mortise
