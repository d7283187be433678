// The grid of an incompressible flow: one uniform Cartesian grid of tiles, what lies at its sides, and the rules by
// which ghost values beyond them follow from the cells.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "mortise/coupler/reference_map/incompressible_setup.hpp"
#include "mortise/coupler/reference_map/point_exchange.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

/// The grid of a flow; solids, which are there before the flow, need one like it. Throws InputError, see check(IncompressibleSetup).
ComponentGrid<2> make_flow_grid(const IncompressibleSetup& setup, const Communicator& comm);

class FlowGrid {
 public:
  /// Throws InputError, see check(IncompressibleSetup). Collective.
  FlowGrid(const IncompressibleSetup& setup, const Communicator& comm);

  const ComponentGrid<2>& grid() const { return grid_; }
  const TileShape<2>& shape() const { return grid_.shape; }
  int tiles() const { return grid_.forest.local_count(); }
  Point<2> spacing() const { return grid_.spacing; }
  SideKind kind(std::size_t side) const { return kinds_[side]; }
  /// The tile touches this side of the domain and the side is not periodic.
  bool at_side(int tile, std::size_t side) const { return touches_[static_cast<std::size_t>(tile)][side]; }

  /// Ghosts of a field of 1, 2 or 4 components from neighbouring tiles. Those beyond the domain are left. Collective.
  void exchange(Field<2>& field) const;

  /// The same of 1 or 2 components at nodes or on edges, see PointExchange. Collective.
  void exchange_points(Field<2>& field) const;

  /// Ghosts of velocities (u, v) at cell centres from neighbours and beyond the sides. v_s is the velocity at the side:
  ///   wall, inflow: 2 v_s − v;  slip wall: the mirror image;  outflow: v of the mirrored cell. Collective.
  void fill_velocity(Field<2>& velocity) const;

  /// Ghosts of a scalar at cell centres; beyond the sides the value of the mirrored cell. Collective.
  void fill_even(Field<2>& field) const;

  /// Ghosts of a scalar at cell centres beyond the sides only: where p is given to be 0 (outflow) −p, elsewhere p, of
  /// the cell at the side.
  void fill_pressure_beyond(Field<2>& pressure) const;

  /// Ghosts of velocities such that sums over the four cells around a node include what flows through the sides: from
  /// neighbours; beyond an inflow the given normal velocity if `inflow`; zero beyond all else. Collective.
  void fill_flux(Field<2>& velocity, bool inflow) const;

  /// Velocities given at a side of the domain, by place along it from the tile's first cell on; indices −2 … n + 1.
  const double* given(int tile, std::size_t side, std::size_t component) const;

 private:
  void list_sides(const IncompressibleSetup& setup);
  void fill_velocity_beyond(TileBlock& block, int tile, std::size_t side) const;

  ComponentGrid<2> grid_;
  std::array<SideKind, 4> kinds_;
  std::vector<std::array<bool, 4>> touches_;                      // by tile
  std::array<std::array<std::vector<double>, 2>, 4> given_;       // by side and component; entry k: place k − 2
  std::array<std::unique_ptr<GhostExchange<2>>, 5> exchange_;     // by number of components
  std::array<std::unique_ptr<PointExchange>, 3> point_exchange_;  // the same
};

/// Where a tile's array is walked across a side: `first` is the offset of the cell at the side, `inward` leads to the
/// next cell inside, `along` to the next one along the side; `count` cells lie along the side.
struct SideWalk {
  std::ptrdiff_t first, inward, along;
  int count;
};
SideWalk walk_of(const TileShape<2>& shape, std::size_t side);

}  // namespace mortise
