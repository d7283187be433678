// The forest of equal tiles of one component grid: topology, neighbours, partition over ranks (p4est).
// p4est has no one-dimensional forest: for Dim = 1 the tiles are a brick of n × 1 trees.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mortise/grids/core/parallel.hpp"
#include "mortise/grids/core/types.hpp"

namespace mortise {

/// What lies beyond a side or corner of a tile.
struct Neighbor {
  enum class Kind { boundary, same_level };  // refinement will add coarser and finer
  Kind kind = Kind::boundary;
  int rank = -1;             // owner
  int local = -1;            // index among the owner's local tiles
  std::int64_t global = -1;  // index along the space-filling curve
};

/// Number of offsets to neighbours with entries −1, 0, 1; the middle one is the tile itself.
template <int Dim>
inline constexpr int offset_count = Dim == 2 ? 9 : 3;

/// Offset number `side` of offset_count, direction 0 fastest; offset_count − 1 − side is the opposite one.
template <int Dim>
constexpr Index<Dim> offset_of(int side) {
  Index<Dim> offset{};
  offset[0] = side % 3 - 1;
  if constexpr (Dim == 2) offset[1] = side / 3 - 1;
  return offset;
}

template <int Dim>
class Forest {
 public:
  /// tiles: number of tiles along each direction at the coarsest level. periodic: per direction.
  /// The partition gives each rank a contiguous piece of the space-filling curve with about equal total weight;
  /// weights (one per tile in *row-major tile-coordinate order*, direction 0 fastest; empty or all 0: equal) must be
  /// the same on every rank.
  Forest(const Communicator& comm, Index<Dim> tiles, std::array<bool, Dim> periodic, std::span<const int> weights = {});
  ~Forest();
  Forest(Forest&&) noexcept;
  Forest& operator=(Forest&&) noexcept;

  const Communicator& communicator() const;
  Index<Dim> tiles() const;  // along each direction, coarsest level
  std::array<bool, Dim> periodic() const;
  std::int64_t global_count() const;
  int local_count() const;
  std::int64_t first_global() const;        // global index of local tile 0
  int level(int local) const;               // refinement level; 0 is the coarsest
  Index<Dim> coordinates(int local) const;  // tile coordinates at its level
  /// offset: entries −1, 0, 1, not all zero. Periodic directions wrap.
  const Neighbor& neighbor(int local, const Index<Dim>& offset) const;
  /// The tile with these level-0 coordinates (all in range): rank, local and global index.
  Neighbor find(const Index<Dim>& coordinates) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mortise
