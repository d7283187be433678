#include "mortise/coupler/reference_map/flow_grid.hpp"

namespace mortise {
namespace {

constexpr std::size_t normal_of(std::size_t side) { return side / 2; }

Index<2> outward(std::size_t side) {
  Index<2> offset{0, 0};
  offset[normal_of(side)] = side % 2 == 0 ? -1 : 1;
  return offset;
}

/// Velocity at place k (cells along the side from the domain's corner on).
Point<2> velocity_at(const FlowSide& side, std::size_t number, const ComponentGrid<2>& grid, int k) {
  const auto n = static_cast<Eigen::Index>(normal_of(number)), t = 1 - n;
  Point<2> v(0, 0);
  if (side.kind == SideKind::wall) v[t] = side.speed;
  if (side.kind != SideKind::inflow) return v;
  Point<2> place;
  place[n] = grid.origin[n] + (number % 2 == 0 ? 0 : grid.cells[static_cast<std::size_t>(n)] * grid.spacing[n]);
  const int last = grid.cells[static_cast<std::size_t>(t)] - 1;
  place[t] = grid.origin[t] + ((k < 0 ? 0 : k > last ? last : k) + 0.5) * grid.spacing[t];
  return side.velocity(place);
}

}  // namespace

ComponentGrid<2> make_flow_grid(const IncompressibleSetup& setup, const Communicator& comm) {
  check(setup);
  const std::array<bool, 2> periodic{setup.sides[west].kind == SideKind::periodic,
                                     setup.sides[south].kind == SideKind::periodic};
  ComponentGrid<2> grid("flow", comm, setup.cells, periodic, TileShape<2>(setup.tile));
  grid.origin = setup.domain.low;
  for (int d = 0; d < 2; ++d)
    grid.spacing[d] = (setup.domain.high[d] - setup.domain.low[d]) / setup.cells[static_cast<std::size_t>(d)];
  return grid;
}

FlowGrid::FlowGrid(const IncompressibleSetup& setup, const Communicator& comm) : grid_(make_flow_grid(setup, comm)) {
  list_sides(setup);
  for (const int components : {1, 2, 4})
    exchange_[static_cast<std::size_t>(components)] =
        std::make_unique<GhostExchange<2>>(grid_.forest, grid_.shape, components);
  for (const int components : {1, 2})
    point_exchange_[static_cast<std::size_t>(components)] = std::make_unique<PointExchange>(grid_, components);
}

void FlowGrid::list_sides(const IncompressibleSetup& setup) {
  touches_.resize(static_cast<std::size_t>(tiles()));
  for (std::size_t s = 0; s < 4; ++s) {
    kinds_[s] = setup.sides[s].kind;
    for (int t = 0; t < tiles(); ++t)
      touches_[static_cast<std::size_t>(t)][s] = grid_.forest.neighbor(t, outward(s)).kind == Neighbor::Kind::boundary;
    const int n = grid_.cells[1 - normal_of(s)];
    for (int k = -2; k < n + 2; ++k) {
      const Point<2> v = velocity_at(setup.sides[s], s, grid_, k);
      for (std::size_t c = 0; c < 2; ++c) given_[s][c].push_back(v[static_cast<Eigen::Index>(c)]);
    }
    for (auto& row : given_[s]) row.resize(row.size() + 2 * TileShape<2>::slack);  // whole vectors may be read
  }
}

const double* FlowGrid::given(int tile, std::size_t side, std::size_t component) const {
  const int first = grid_.first_cell(tile)[1 - normal_of(side)];
  return given_[side][component].data() + first + 2;
}

void FlowGrid::exchange(Field<2>& field) const {
  static constexpr std::array<double, 4> filler{};
  const auto n = static_cast<std::size_t>(field.components());
  exchange_[n]->fill(field, std::span(filler).first(n));
}

void FlowGrid::exchange_points(Field<2>& field) const {
  point_exchange_[static_cast<std::size_t>(field.components())]->fill(field);
}

SideWalk walk_of(const TileShape<2>& shape, std::size_t side) {
  const auto at = [&](int i, int j) { return static_cast<std::ptrdiff_t>(shape.at(i, j)); };
  const int nx = shape.cells[0], ny = shape.cells[1];
  switch (side) {
    case west:
      return {at(0, 0), 1, shape.stride, ny};
    case east:
      return {at(nx - 1, 0), -1, shape.stride, ny};
    case south:
      return {at(0, 0), shape.stride, 1, nx};
    default:
      return {at(0, ny - 1), -shape.stride, 1, nx};
  }
}

void FlowGrid::fill_velocity_beyond(TileBlock& block, int tile, std::size_t side) const {
  const SideWalk walk = walk_of(grid_.shape, side);
  const SideKind kind = kinds_[side];
  for (std::size_t c = 0; c < 2; ++c) {
    double* const q = block.component(static_cast<int>(c)) + walk.first;
    const double* const v = given(tile, side, c);
    const bool odd = velocity_given(kind) || (kind == SideKind::slip_wall && c == normal_of(side));
    for (int layer = 0; layer < 2; ++layer) {
      const std::ptrdiff_t mirrored = layer * walk.inward, ghost = -(layer + 1) * walk.inward;
      for (int k = -2; k < walk.count + 2; ++k) {
        const std::ptrdiff_t place = k * walk.along;
        q[place + ghost] = odd ? 2 * v[k] - q[place + mirrored] : q[place + mirrored];
      }
    }
  }
}

void FlowGrid::fill_velocity(Field<2>& velocity) const {
  exchange(velocity);
  for (int t = 0; t < tiles(); ++t)
    for (std::size_t side = 0; side < 4; ++side)
      if (at_side(t, side)) fill_velocity_beyond(velocity.tile(t), t, side);
}

void FlowGrid::fill_pressure_beyond(Field<2>& pressure) const {
  for (int t = 0; t < tiles(); ++t)
    for (std::size_t side = 0; side < 4; ++side) {
      if (!at_side(t, side)) continue;
      const SideWalk walk = walk_of(grid_.shape, side);
      const double sign = kinds_[side] == SideKind::outflow ? -1 : 1;
      double* const p = pressure.tile(t).component(0) + walk.first;
      for (int k = 0; k < walk.count; ++k) p[k * walk.along - walk.inward] = sign * p[k * walk.along];
    }
}

void FlowGrid::fill_flux(Field<2>& velocity, bool inflow) const {
  exchange(velocity);
  for (int t = 0; t < tiles(); ++t) {
    TileBlock& block = velocity.tile(t);
    for (std::size_t side = 0; side < 4; ++side) {
      if (!at_side(t, side)) continue;
      const SideWalk walk = walk_of(grid_.shape, side);
      for (std::size_t c = 0; c < 2; ++c) {
        const double* const v = given(t, side, c);
        const bool flows = inflow && kinds_[side] == SideKind::inflow && c == normal_of(side);
        double* const q = block.component(static_cast<int>(c)) + walk.first - walk.inward;
        for (int k = -1; k <= walk.count; ++k) q[k * walk.along] = flows ? v[k] : 0;
      }
    }
    for (const std::size_t x : {west, east})
      for (const std::size_t y : {south, north})
        if (at_side(t, x) && at_side(t, y))
          for (int c = 0; c < 2; ++c)
            block.component(
                c)[grid_.shape.at(x == west ? -1 : grid_.shape.cells[0], y == south ? -1 : grid_.shape.cells[1])] = 0;
  }
}

void FlowGrid::fill_even(Field<2>& field) const {
  exchange(field);
  for (int t = 0; t < tiles(); ++t)
    for (std::size_t side = 0; side < 4; ++side) {
      if (!at_side(t, side)) continue;
      const SideWalk walk = walk_of(grid_.shape, side);
      for (int c = 0; c < field.components(); ++c) {
        double* const q = field.tile(t).component(c) + walk.first;
        for (int layer = 0; layer < 2; ++layer)
          for (int k = -2; k < walk.count + 2; ++k)
            q[k * walk.along - (layer + 1) * walk.inward] = q[k * walk.along + layer * walk.inward];
      }
    }
}

}  // namespace mortise
