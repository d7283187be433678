#include "mortise/coupler/reference_map/point_exchange.hpp"

#include <array>
#include <span>

namespace mortise {
namespace {

constexpr std::array<double, 4> filler{};

}  // namespace

PointExchange::PointExchange(const ComponentGrid<2>& grid, int components)
    : grid_(&grid), exchange_(grid.forest, grid.shape, components) {
  const bool needed = (!grid.periodic[0] && grid.forest.tiles()[1] > 1) ||
                      (!grid.periodic[1] && grid.forest.tiles()[0] > 1) || grid.periodic[0] != grid.periodic[1];
  if (needed) last_ = std::make_unique<Field<2>>(grid.shape, components, grid.forest.local_count());
}

void PointExchange::fill(Field<2>& field) {
  exchange_.fill(field, std::span(filler).first(static_cast<std::size_t>(field.components())));
  if (!last_) return;
  for (std::size_t d = 0; d < 2; ++d)
    if (!grid_->periodic[d]) fill_last(field, d);
}

/// Column nx (d = 0) or row ny (d = 1) of the tiles at the side travels as column or row 0.
void PointExchange::fill_last(Field<2>& field, std::size_t d) {
  const TileShape<2>& shape = grid_->shape;
  const int n = shape.cells[d], along = shape.cells[1 - d];
  const auto at = [&](int across, int k) { return d == 0 ? shape.at(across, k) : shape.at(k, across); };
  const auto last_tile = [&](int t) { return grid_->forest.coordinates(t)[d] == grid_->forest.tiles()[d] - 1; };
  for (int t = 0; t < field.tiles(); ++t)
    for (int c = 0; c < field.components() && last_tile(t); ++c)
      for (int k = 0; k < along; ++k) last_->tile(t).component(c)[at(0, k)] = field.tile(t).component(c)[at(n, k)];
  exchange_.fill(*last_, std::span(filler).first(static_cast<std::size_t>(field.components())));
  for (int t = 0; t < field.tiles(); ++t) {
    if (!last_tile(t)) continue;
    for (const bool high : {false, true}) {
      Index<2> offset{0, 0};
      offset[1 - d] = high ? 1 : -1;
      if (grid_->forest.neighbor(t, offset).kind == Neighbor::Kind::boundary) continue;
      for (int c = 0; c < field.components(); ++c)
        for (const int k : high ? std::array{along, along + 1} : std::array{-2, -1})
          field.tile(t).component(c)[at(n, k)] = last_->tile(t).component(c)[at(0, k)];
    }
  }
}

}  // namespace mortise
