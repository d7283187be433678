// What the solids of a tile add to the stresses and viscosities on edges of its cells: elastic stress with the damping
// of what is as short as the cells, and what pushes bodies from each other and from walls.
#pragma once

#include "mortise/coupler/reference_map/flow_solids.hpp"

namespace mortise {

/// A body on the tile.
struct EdgeBody {
  const FlowBody* body;
  const TileBlock* map;
  TileWindow window;
  bool folded;  // BodyMap::folded()
};

struct EdgeSolids {
  const ComponentGrid<2>* grid;
  int tile;
  double width;  // of the blur zone, to each side
  double fluid_viscosity;
  double damping;             // part of half the impedance, see FlowSolidsSetup
  double time;                // for actuation
  const TileBlock* velocity;  // of the flow, ghosts filled; nullptr: at rest
  SolidFields* fields;
};

/// Adds s (τ + damping) to stresses and s (η − μ_f) to viscosities, on all edges.
void add_elastic(const EdgeSolids& tile, const EdgeBody& body);

/// Where the blur zones of two bodies overlap a pressure along n = ∇φ_other − ∇φ pushes `body` away, deviatoric and
/// growing with the overlap (Rycroft et al., J. Fluid Mech. 898 (2020) A9).
void add_contact(const EdgeSolids& tile, const EdgeBody& body, const EdgeBody& other);

/// The same between two parts of the surface of one folded body, on edges where its map jumps from one to the other.
void add_self_contact(const EdgeSolids& tile, const EdgeBody& body);

/// The same within three blur widths of a side (west, east, south, north) of the domain.
void add_wall_push(const EdgeSolids& tile, const EdgeBody& body, std::size_t side);

}  // namespace mortise
