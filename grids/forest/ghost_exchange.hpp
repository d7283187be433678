// Ghost layers from neighbouring tiles (sides and corners), on this rank by copy, across ranks by messages
// aggregated per pair of ranks. Ghost cells beyond a physical boundary are left alone.
#pragma once

#include <memory>
#include <span>

#include "mortise/grids/forest/field.hpp"
#include "mortise/grids/forest/forest.hpp"

namespace mortise {

template <int Dim>
class GhostExchange {
 public:
  GhostExchange(const Forest<Dim>& forest, const TileShape<Dim>& shape, int components);
  ~GhostExchange();
  GhostExchange(GhostExchange&&) noexcept;
  GhostExchange& operator=(GhostExchange&&) noexcept;

  /// Fills all ghost cells of all allocated tiles that have a neighbour. Where the neighbour is unallocated
  /// (a tile wholly inside a hole) the ghost cells get `filler` (one value per component).
  /// Collective over the ranks of the forest.
  void fill(Field<Dim>& field, std::span<const double> filler) const;

  /// The same for the listed local tiles as receivers. What other ranks send is still exchanged, and received by all
  /// tiles. Collective.
  void fill(Field<Dim>& field, std::span<const double> filler, std::span<const int> tiles) const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace mortise
