#include "mortise/grids/forest/forest.hpp"

#include <p4est_connectivity.h>
#include <p4est_extended.h>

#include <algorithm>
#include <numeric>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// One tile as every rank knows it.
struct Leaf {
  int level = 0;
  std::array<int, 2> coordinates{};  // at its level
};

struct FreeForest {
  void operator()(p4est_t* p) const { p4est_destroy(p); }
};
struct FreeConnectivity {
  void operator()(p4est_connectivity_t* p) const { p4est_connectivity_destroy(p); }
};

/// Coordinates of a tree of a brick, which p4est numbers along its own curve: those of its first vertex.
std::array<int, 2> tree_coordinates(const p4est_connectivity_t& brick, p4est_topidx_t tree) {
  const double* x = brick.vertices + 3 * brick.tree_to_vertex[P4EST_CHILDREN * tree];
  return {static_cast<int>(x[0] + 0.5), static_cast<int>(x[1] + 0.5)};
}

/// What the callback of the partition reads: weights in row-major order of tile coordinates.
struct Weights {
  std::span<const int> values;
  int row_length = 0;
};

int weight_of(p4est_t* forest, p4est_topidx_t tree, p4est_quadrant_t*) {
  const auto& weights = *static_cast<const Weights*>(forest->user_pointer);
  const auto [i, j] = tree_coordinates(*forest->connectivity, tree);
  return weights.values[static_cast<std::size_t>(j * weights.row_length + i)];
}

/// This rank's tiles in the order of the space-filling curve.
std::vector<Leaf> local_leaves(const p4est_t& forest) {
  std::vector<Leaf> leaves;
  for (p4est_topidx_t t = forest.first_local_tree; t <= forest.last_local_tree; ++t) {
    const auto* tree = static_cast<const p4est_tree_t*>(sc_array_index(forest.trees, static_cast<std::size_t>(t)));
    const auto [i, j] = tree_coordinates(*forest.connectivity, t);
    for (std::size_t q = 0; q < tree->quadrants.elem_count; ++q) {
      const auto* quadrant = reinterpret_cast<const p4est_quadrant_t*>(tree->quadrants.array) + q;
      const int level = quadrant->level;
      leaves.push_back({level,
                        {(i << level) + (quadrant->x >> (P4EST_MAXLEVEL - level)),
                         (j << level) + (quadrant->y >> (P4EST_MAXLEVEL - level))}});
    }
  }
  return leaves;
}

}  // namespace

template <int Dim>
struct Forest<Dim>::Implementation {
  Communicator comm;
  Index<Dim> tiles;
  std::array<bool, Dim> periodic;
  std::vector<std::int64_t> first;      // global index of each rank's first tile; one more entry: the total
  std::vector<Leaf> leaves;             // all tiles of all ranks along the curve
  std::vector<std::int64_t> global_at;  // global index by row-major level-0 coordinates
  std::vector<Neighbor> neighbors;      // offset_count per local tile

  void grow(std::span<const int> weights);
  void tabulate();
  void connect();
  Index<Dim> coordinates(std::int64_t global) const;
  Neighbor tile_at(const Index<Dim>& c) const;
  Neighbor beyond(const Index<Dim>& from, const Index<Dim>& offset) const;
  std::size_t row_major(const Index<Dim>& c) const {
    return static_cast<std::size_t>(Dim == 2 ? c[Dim - 1] * tiles[0] + c[0] : c[0]);
  }
};

/// Lets p4est number and partition the tiles; `leaves` and `first` are all that is kept of its forest.
template <int Dim>
void Forest<Dim>::Implementation::grow(std::span<const int> weights) {
  sc_set_log_defaults(nullptr, nullptr, SC_LP_ERROR);
  const int across = Dim == 2 ? tiles[Dim - 1] : 1;
  const int periodic_across = Dim == 2 && periodic[Dim - 1] ? 1 : 0;
  const std::unique_ptr<p4est_connectivity_t, FreeConnectivity> brick(
      p4est_connectivity_new_brick(tiles[0], across, periodic[0] ? 1 : 0, periodic_across));
  Weights table{weights, tiles[0]};
  const std::unique_ptr<p4est_t, FreeForest> forest(
      p4est_new_ext(comm.raw(), brick.get(), 0, 0, 1, 0, nullptr, &table));
  const bool weighted = std::accumulate(weights.begin(), weights.end(), std::int64_t{0}) > 0;
  p4est_partition(forest.get(), 0, weighted ? weight_of : nullptr);
  first.assign(forest->global_first_quadrant, forest->global_first_quadrant + comm.size() + 1);
  leaves = comm.gather_all(local_leaves(*forest));
}

template <int Dim>
Index<Dim> Forest<Dim>::Implementation::coordinates(std::int64_t global) const {
  const Leaf& leaf = leaves[static_cast<std::size_t>(global)];
  Index<Dim> c{};
  for (std::size_t d = 0; d < Dim; ++d) c[d] = leaf.coordinates[d];
  return c;
}

template <int Dim>
void Forest<Dim>::Implementation::tabulate() {
  global_at.resize(leaves.size());
  for (std::int64_t g = 0; g < first.back(); ++g) global_at[row_major(coordinates(g))] = g;
}

template <int Dim>
Neighbor Forest<Dim>::Implementation::tile_at(const Index<Dim>& c) const {
  const std::int64_t global = global_at[row_major(c)];
  const auto owner = std::upper_bound(first.begin(), first.end(), global) - first.begin() - 1;
  return {Neighbor::Kind::same_level, static_cast<int>(owner),
          static_cast<int>(global - first[static_cast<std::size_t>(owner)]), global};
}

/// The tile at `from` + `offset`, around periodic directions; nothing beyond the others.
template <int Dim>
Neighbor Forest<Dim>::Implementation::beyond(const Index<Dim>& from, const Index<Dim>& offset) const {
  Index<Dim> c{};
  for (std::size_t d = 0; d < Dim; ++d) {
    c[d] = from[d] + offset[d];
    if (periodic[d]) c[d] = (c[d] + tiles[d]) % tiles[d];
    if (c[d] < 0 || c[d] >= tiles[d]) return {};
  }
  return tile_at(c);
}

template <int Dim>
void Forest<Dim>::Implementation::connect() {
  const auto rank = static_cast<std::size_t>(comm.rank());
  for (std::int64_t g = first[rank]; g < first[rank + 1]; ++g)
    for (int side = 0; side < offset_count<Dim>; ++side)
      neighbors.push_back(beyond(coordinates(g), offset_of<Dim>(side)));
}

template <int Dim>
Forest<Dim>::Forest(const Communicator& comm, Index<Dim> tiles, std::array<bool, Dim> periodic,
                    std::span<const int> weights)
    : implementation_(new Implementation{comm, tiles, periodic, {}, {}, {}, {}}) {
  std::int64_t count = 1;
  for (const int n : tiles) count *= n;
  MORTISE_ASSERT(*std::min_element(tiles.begin(), tiles.end()) > 0, "a forest without tiles");
  MORTISE_ASSERT(weights.empty() || static_cast<std::int64_t>(weights.size()) == count, "one weight per tile");
  implementation_->grow(weights);
  implementation_->tabulate();
  implementation_->connect();
}

template <int Dim>
Forest<Dim>::~Forest() = default;
template <int Dim>
Forest<Dim>::Forest(Forest&&) noexcept = default;
template <int Dim>
Forest<Dim>& Forest<Dim>::operator=(Forest&&) noexcept = default;

template <int Dim>
const Communicator& Forest<Dim>::communicator() const {
  return implementation_->comm;
}

template <int Dim>
Index<Dim> Forest<Dim>::tiles() const {
  return implementation_->tiles;
}

template <int Dim>
std::array<bool, Dim> Forest<Dim>::periodic() const {
  return implementation_->periodic;
}

template <int Dim>
std::int64_t Forest<Dim>::global_count() const {
  return implementation_->first.back();
}

template <int Dim>
int Forest<Dim>::local_count() const {
  const auto rank = static_cast<std::size_t>(implementation_->comm.rank());
  return static_cast<int>(implementation_->first[rank + 1] - implementation_->first[rank]);
}

template <int Dim>
std::int64_t Forest<Dim>::first_global() const {
  return implementation_->first[static_cast<std::size_t>(implementation_->comm.rank())];
}

template <int Dim>
int Forest<Dim>::level(int local) const {
  return implementation_->leaves[static_cast<std::size_t>(first_global() + local)].level;
}

template <int Dim>
Index<Dim> Forest<Dim>::coordinates(int local) const {
  return implementation_->coordinates(first_global() + local);
}

template <int Dim>
const Neighbor& Forest<Dim>::neighbor(int local, const Index<Dim>& offset) const {
  int side = offset[0] + 1;
  if constexpr (Dim == 2) side += 3 * (offset[1] + 1);
  return implementation_->neighbors[static_cast<std::size_t>(local * offset_count<Dim> + side)];
}

template <int Dim>
Neighbor Forest<Dim>::find(const Index<Dim>& coordinates) const {
  return implementation_->tile_at(coordinates);
}

template class Forest<1>;
template class Forest<2>;

}  // namespace mortise
