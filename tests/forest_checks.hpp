// What must hold for every forest and ghost exchange, on any number of ranks.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "mortise/grids/forest/ghost_exchange.hpp"

namespace mortise::testing {

inline constexpr double untouched = -77;  // what ghost cells hold before an exchange

/// Exact, different in every cell and component of the whole grid.
template <int Dim>
double cell_value(const Index<Dim>& cell, int component) {
  double value = component;
  for (std::size_t d = 0; d < Dim; ++d) value = 1000 * value + cell[d];
  return value;
}

/// Whether a tile has memory, by global index: the same answer on every rank.
using Allocation = std::function<bool(std::int64_t)>;

/// A field with cell_value in all cells of allocated tiles and `untouched` in their ghost cells.
template <int Dim>
Field<Dim> numbered_field(const Forest<Dim>& forest, const TileShape<Dim>& shape, int components,
                          const Allocation& allocated) {
  Field<Dim> field(shape, components, forest.local_count());
  for (int t = 0; t < forest.local_count(); ++t) {
    if (!allocated(forest.first_global() + t)) {
      field.tile(t).release();
      continue;
    }
    for (double& value : field.tile(t).all()) value = untouched;
    const Index<Dim> tile = forest.coordinates(t);
    for (int n = 0; n < shape.count(); ++n) {
      Index<Dim> local{}, global{};
      for (int d = 0, rest = n; d < Dim; rest /= shape.cells[static_cast<std::size_t>(d)], ++d) {
        const auto k = static_cast<std::size_t>(d);
        local[k] = rest % shape.cells[k];
        global[k] = tile[k] * shape.cells[k] + local[k];
      }
      for (int c = 0; c < components; ++c) field.tile(t).component(c)[shape.at(local)] = cell_value<Dim>(global, c);
    }
  }
  return field;
}

/// What cell `local` (ghost or not) of the tile at `tile` must hold after an exchange.
template <int Dim>
double expected_value(const Forest<Dim>& forest, const TileShape<Dim>& shape, const Index<Dim>& tile,
                      const Index<Dim>& local, int component, const Allocation& allocated, double filler) {
  Index<Dim> cell{}, owner{};
  for (std::size_t d = 0; d < Dim; ++d) {
    const int cells = forest.tiles()[d] * shape.cells[d];
    cell[d] = tile[d] * shape.cells[d] + local[d];
    if (forest.periodic()[d]) cell[d] = (cell[d] + cells) % cells;
    if (cell[d] < 0 || cell[d] >= cells) return untouched;
    owner[d] = cell[d] / shape.cells[d];
  }
  return allocated(forest.find(owner).global) ? cell_value<Dim>(cell, component) : filler;
}

/// The number of wrong cells of all local tiles, ghost cells included.
template <int Dim>
int wrong_cells(const Forest<Dim>& forest, const Field<Dim>& field, const Allocation& allocated,
                const std::vector<double>& filler) {
  const TileShape<Dim>& shape = field.shape();
  int wrong = 0;
  const auto check = [&](int t, const Index<Dim>& local) {
    for (int c = 0; c < field.components(); ++c) {
      const double expected = expected_value<Dim>(forest, shape, forest.coordinates(t), local, c, allocated,
                                                  filler[static_cast<std::size_t>(c)]);
      if (field.tile(t).component(c)[shape.at(local)] != expected) ++wrong;
    }
  };
  for (int t = 0; t < field.tiles(); ++t) {
    if (!field.tile(t).allocated()) continue;
    for (int i = -2; i < shape.cells[0] + 2; ++i) {
      if constexpr (Dim == 1) check(t, {i});
      if constexpr (Dim == 2)
        for (int j = -2; j < shape.cells[1] + 2; ++j) check(t, {i, j});
    }
  }
  return wrong;
}

/// Fills a numbered field and counts wrong cells.
template <int Dim>
int wrong_after_exchange(const Forest<Dim>& forest, const Index<Dim>& cells, int components,
                         const Allocation& allocated) {
  const TileShape<Dim> shape(cells);
  std::vector<double> filler;
  for (int c = 0; c < components; ++c) filler.push_back(-1.0 - c);
  const GhostExchange<Dim> exchange(forest, shape, components);
  Field<Dim> field = numbered_field<Dim>(forest, shape, components, allocated);
  exchange.fill(field, filler);
  return wrong_cells<Dim>(forest, field, allocated, filler);
}

inline bool everywhere(std::int64_t) { return true; }

/// Every tile is found where it is, and neighbours are each other's neighbours.
template <int Dim>
void expect_consistent(const Forest<Dim>& forest) {
  for (int t = 0; t < forest.local_count(); ++t) {
    const Neighbor self = forest.find(forest.coordinates(t));
    EXPECT_EQ(self.rank, forest.communicator().rank());
    EXPECT_EQ(self.local, t);
    EXPECT_EQ(self.global, forest.first_global() + t);
    EXPECT_EQ(forest.level(t), 0);
    for (int side = 0; side < offset_count<Dim>; ++side) {
      const Index<Dim> offset = offset_of<Dim>(side);
      Index<Dim> c = forest.coordinates(t);
      bool inside = true;
      for (std::size_t d = 0; d < Dim; ++d) {
        c[d] += offset[d];
        if (forest.periodic()[d]) c[d] = (c[d] + forest.tiles()[d]) % forest.tiles()[d];
        inside = inside && c[d] >= 0 && c[d] < forest.tiles()[d];
      }
      const Neighbor& beyond = forest.neighbor(t, offset);
      ASSERT_EQ(beyond.kind == Neighbor::Kind::same_level, inside);
      if (!inside) continue;
      EXPECT_EQ(beyond.global, forest.find(c).global);
      EXPECT_EQ(beyond.rank, forest.find(c).rank);
      EXPECT_EQ(beyond.local, forest.find(c).local);
    }
  }
}

}  // namespace mortise::testing
