// The difference between two runs of one scene at the same time: how large it is, cell by cell and body by body. Both
// runs have the same grids; cells that are no gas in one of them do not count.
#pragma once

#include "mortise/coupler/simulation.hpp"

namespace mortise {

struct Difference {
  // Σ V (½ρ|δu|² + ½ δp²/ρc²) over the gas, Σ V (½ρ|δv|² + W(δσ)) over elastic solids with W the strain energy of the
  // linear law, ½ m |δv|² + ½ I δω² of rigid bodies. Per unit depth (1D: per area).
  double energy = 0;
  double amplitude = 0;  // largest |δu|/c and |δp|/ρc² in the gas, |δv|/c_p in solids
};

/// Of `other` from `base`, whose densities and speeds of sound count. Collective.
template <int Dim>
Difference difference(const Simulation<Dim>& base, const Simulation<Dim>& other);

}  // namespace mortise
