// One step of a tile where gas and hyperelastic solids share cells: one density, velocity and energy for both.
//
// With s the share of a solid (level_set.hpp) the conserved state and the stress are those of a mixture,
//   ρ = m + Σ s ρ_s,   E = q/(γ − 1) + Σ s e_s + ½ρ|v|²,   σ = −q I + Σ s σ_s,
// ρ_s, e_s and σ_s being functions of the gradient of the reference map (solid_point.hpp). m and q are what is left: m
// next to nothing within a solid, q there next to p_e; gas and solids at rest have q = p_e everywhere. q − p_e Σ s is
// the gas's part of the pressure. Where s = 0 they are the gas's density and pressure, and the step is that of
// fluid/cartesian_kernel.hpp with the HLLC solver.
// * Conservative: every face has one flux, a function of the states of both sides.
// * m, v and q are reconstructed and taken to t + Δt/2 as in fluid/reconstruction.hpp; Σ s ρ_s, Σ s e_s and the stress
// at a face
//   come from the map at t + Δt/2, by differences between the cells on both sides. So solids do not spread, and waves
//   in them see velocities and maps staggered in time: no numerical dissipation but the upwinding of the velocities.
// * The Riemann problem has the waves of a solid: two along the normal (speeds of Davis 1988), a contact, and between
// them
//   two of the tangential velocity; where there is no stiffness against shear these merge with the contact, and it is
//   HLLC.
// Second order where fields are smooth; across the blur zone, which is a few cells wide, first.
#pragma once

#include <span>

#include "mortise/coupler/reference_map/body_map.hpp"
#include "mortise/fluid/godunov_step.hpp"

namespace mortise {

/// Components of the field of what solids take of the cells: Σ s ρ_s, Σ s e_s, Σ s, and Σ s ρc² of the fastest wave.
namespace composition {
enum Component { mass, energy, share, stiffness, count };
}

/// A body on the tile at hand: its map at the half of the step (layout of the tile).
struct TileBody {
  const SolidLaw* law;
  const TileBlock* map;
};

struct MixtureTile {
  CartesianTile<2> cells;
  const TileBlock* composition;      // at t
  std::span<const TileBody> bodies;  // on this tile
  double blur;                       // half width w of the blur zone, a length
  double pressure;                   // p̃_e
};

/// Advances the tile like godunov_step(): ghosts of `now`, of the composition and of the maps are filled. The result's
/// rate is not known before the composition at the end of the step is (mixture_rate()). Limiter and γ are those of the
/// options.
StepResult mixture_step(const MixtureTile& tile, double dt, const StepOptions& options);

/// Σ over bodies at the cells of a tile, from their maps; sets the tile's own cells of `composition`.
void compose(const TileShape<2>& shape, const std::array<double, 2>& spacing, std::span<const TileBody> bodies,
             double blur, TileBlock& composition);

/// max of Σ_d (|u_d| + c)/h_d of the state `next` over the tile. Where solid and gas share a cell the gas's pressure is
/// kept above a thousandth of p̃_e; `restored` is increased by the energy per volume that takes, summed over cells.
StepResult mixture_rate(const MixtureTile& tile, const StepOptions& options, double& restored);

}  // namespace mortise
