// Ghost cells of an elastic solid: from neighbouring tiles; beyond the edges of a grid by extrapolation or, on exact
// sides, from the exact solution.
#include "mortise/solid/elastic_solver.hpp"

namespace mortise {
namespace {

constexpr std::array<Side, 4> all_sides = {Side::west, Side::east, Side::south, Side::north};

}  // namespace

/// Nothing lies beyond this side of the tile.
bool ElasticSolver::at_edge(int grid, int tile, Side side) const {
  constexpr std::array<Index<2>, 4> offsets = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  return grid_of(grid).forest.neighbor(tile, offsets[static_cast<std::size_t>(side)]).kind == Neighbor::Kind::boundary;
}

/// What happens beyond this side of the tile; nullptr where another tile or the other grid is.
const ElasticSide* ElasticSolver::boundary(int grid, int tile, Side side) const {
  const bool fitted = !grid_of(grid).background(), fringe = fitted && overlap_ && side == Side::north;
  if (fringe || !at_edge(grid, tile, side)) return nullptr;
  return &(fitted ? setup_.fitted_sides : setup_.sides)[static_cast<std::size_t>(side)];
}

void ElasticSolver::fill_ghosts(double time) {
  const auto scope = timers_("ghosts");
  time_ = time;
  for (int g = 0; g < static_cast<int>(grids_.size()); ++g) {
    exchanges_[static_cast<std::size_t>(g)].fill(field(g), rest_);
    for (int t = 0; t < field(g).tiles(); ++t) {
      extrapolate(g, t);
      fill_exact(g, t, time);
    }
  }
}

/// West and east first, over all rows that have a value; then south and north over the whole width, corners included.
void ElasticSolver::extrapolate(int g, int t) {
  const TileShape<2>& shape = grid_of(g).shape;
  const int ghosts = TileShape<2>::ghosts;
  const int low = at_edge(g, t, Side::south) ? 0 : -ghosts;
  const int high = shape.cells[1] + (at_edge(g, t, Side::north) ? 0 : ghosts);
  for (const Side side : all_sides) {
    if (!at_edge(g, t, side)) continue;
    const bool upright = side == Side::west || side == Side::east;
    extrapolate_ghosts(shape, field(g).tile(t), side, upright ? low : -ghosts, upright ? high : shape.cells[0] + ghosts,
                       setup_.options);
  }
}

void ElasticSolver::fill_exact(int g, int t, double time) {
  const TileShape<2>& shape = grid_of(g).shape;
  const int ghosts = TileShape<2>::ghosts;
  for (const Side side : all_sides) {
    const ElasticSide* beyond = boundary(g, t, side);
    if (!beyond || beyond->kind != ElasticBoundary::exact) continue;
    Index<2> low = {-ghosts, -ghosts}, high = {shape.cells[0] + ghosts, shape.cells[1] + ghosts};
    const auto d = static_cast<std::size_t>(side) / 2;
    (side == Side::west || side == Side::south ? high[d] : low[d]) =
        side == Side::west || side == Side::south ? 0 : shape.cells[d];
    for_each_index<2>(low, high, [&](const Index<2>& cell) {
      const ElasticState state = state_of_cell(setup_.exact, g, t, cell, time);
      for (int c = 0; c < components(); ++c)
        field(g).tile(t).component(c)[shape.at(cell)] = state[static_cast<std::size_t>(c)];
    });
  }
}

}  // namespace mortise
