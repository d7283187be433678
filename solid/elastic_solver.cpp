// Setting up grids and fields of an elastic solid, its initial state, and what follows a step.
#include "mortise/solid/elastic_solver.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr int longest_tile = 128;  // cells along the curve
constexpr int deepest_tile = 64;   // layers

/// Cells per tile: all of them, or an even part no longer than `most`.
int tile_length(const std::string& name, int cells, int most) {
  if (cells <= most && cells % 2 == 0) return cells;
  if (cells % 2 != 0)
    throw InputError("the grid fitted to " + name + " has " + std::to_string(cells) +
                     " cells in one direction; it must be an even number");
  int parts = 2;
  while (cells % parts != 0 || cells / parts > most || cells / parts % 2 != 0) ++parts;
  return cells / parts;
}

void check_side(const ElasticSetup& setup, const ElasticSide& side, bool may_be_periodic, bool may_be_interface) {
  if (side.kind == ElasticBoundary::periodic && !may_be_periodic)
    throw InputError("a side of solid " + setup.name + " is periodic, but its grid or the opposite side is not");
  if (side.kind == ElasticBoundary::interface && !may_be_interface)
    throw InputError("solid " + setup.name + " has an interface on a side other than layer 0 of its fitted grid");
  if (side.kind == ElasticBoundary::exact && !setup.exact)
    throw InputError("a side of solid " + setup.name + " is exact, but no exact solution is given");
}

void check(const ElasticSetup& setup) {
  setup.options.material.check();
  const bool cartesian = setup.cells != Index<2>{};
  if (!cartesian && !setup.fitted) throw InputError("solid " + setup.name + " has no grid");
  if (cartesian && setup.fitted && !setup.atlas)
    throw InputError("solid " + setup.name + " has two grids but nothing says how they overlap");
  for (std::size_t s = 0; cartesian && s < 4; ++s)
    check_side(setup, setup.sides[s], setup.sides[s ^ 1U].kind == ElasticBoundary::periodic, false);
  for (std::size_t d = 0; cartesian && d < 2; ++d)
    if (setup.tile[d] <= 0 || setup.tile[d] % 2 != 0 || setup.cells[d] <= 0 || setup.cells[d] % setup.tile[d] != 0)
      throw InputError("a grid of " + std::to_string(setup.cells[d]) + " cells cannot be cut into even tiles of " +
                       std::to_string(setup.tile[d]));
  if (!setup.fitted) return;
  for (std::size_t s = setup.fitted->periodic ? 2 : 0; s < 4; ++s)
    check_side(setup, setup.fitted_sides[s], false, static_cast<Side>(s) == Side::south);
  if (const Index<2> folded = first_folded_cell(*setup.fitted); folded[0] >= 0)
    throw InputError("the grid fitted to " + setup.name + " is folded at cell (" + std::to_string(folded[0]) + ", " +
                     std::to_string(folded[1]) + ")");
}

/// v = 0, σ = 0 or F = I, u = 0.
ElasticState rest_state(StressLaw law) {
  ElasticState rest{};
  if (law != StressLaw::linear) rest[2] = rest[5] = 1;
  return rest;
}

/// Without copying where `spent`: the block is about to be replaced as a whole.
void keep(TileBlock& block, TileBlock& memory, bool spent) {
  if (spent)
    std::swap(block, memory);
  else
    std::ranges::copy(block.all(), memory.all().begin());
}

}  // namespace

ElasticSolver::ElasticSolver(const Communicator& comm, ElasticSetup setup, PhaseTimers& timers)
    : comm_(comm), setup_(std::move(setup)), timers_(timers), rest_(rest_state(law())) {
  check(setup_);
  append_grids();
  for (const ComponentGrid<2>& grid : grids_) {
    const int tiles = grid.forest.local_count();
    now_.emplace_back(grid.shape, components(), tiles);
    next_.emplace_back(grid.shape, components(), tiles);
    exchanges_.emplace_back(grid.forest, grid.shape, components());
    rates_.emplace_back(static_cast<std::size_t>(tiles), 0.0);
    least_j_.emplace_back(static_cast<std::size_t>(tiles), 1.0);
    computed_.emplace_back(static_cast<std::size_t>(tiles), std::uint8_t{0});
  }
  new_rates_ = rates_;
  new_least_j_ = least_j_;
  build_nodes();
  if (grids_.size() == 2) {
    const OverlapBody<2> body{setup_.atlas, setup_.fitted->spacing, setup_.fitted->layers};
    setup_.overlap.clip = setup_.options.limiter != ElasticLimiter::none;
    overlap_ = std::make_unique<Overlap<2>>(comm_, grids_, std::vector{body}, setup_.domain, setup_.overlap);
  } else if (setup_.fitted) {
    finder_ = std::make_unique<CellFinder>(*setup_.fitted);
  }
}

void ElasticSolver::append_grids() {
  const bool cartesian = setup_.cells != Index<2>{}, composite = cartesian && setup_.fitted;
  if (cartesian) {
    const auto wraps = [&](Side side) {
      return setup_.sides[static_cast<std::size_t>(side)].kind == ElasticBoundary::periodic;
    };
    grids_.emplace_back(setup_.name + (composite ? "_cartesian" : ""), comm_, setup_.cells,
                        std::array{wraps(Side::west), wraps(Side::south)}, TileShape<2>(setup_.tile));
    grids_.back().origin = setup_.domain.low;
    const Point<2> size = setup_.domain.high - setup_.domain.low;
    grids_.back().spacing = {size.x() / setup_.cells[0], size.y() / setup_.cells[1]};
  }
  if (!setup_.fitted) return;
  const GrownGrid& fitted = *setup_.fitted;
  const TileShape<2> shape(
      {tile_length(setup_.name, fitted.along, longest_tile), tile_length(setup_.name, fitted.layers, deepest_tile)});
  grids_.emplace_back(setup_.name + (composite ? "_fitted" : ""), comm_, Index<2>{fitted.along, fitted.layers},
                      std::array{fitted.periodic, false}, shape);
  grids_.back().body = 0;
  grids_.back().spacing.setConstant(fitted.spacing);
}

int ElasticSolver::components() const { return elastic_components(law()); }

void ElasticSolver::initialize(const ElasticFunction& initial, double time) {
  for_each_tile([&](int g, int t) {
    const TileShape<2>& shape = grid_of(g).shape;
    for (int c = 0; c < components(); ++c) {
      const double rest = rest_[static_cast<std::size_t>(c)];
      std::fill_n(field(g).tile(t).component(c), shape.plane, rest);
      std::fill_n(next_[static_cast<std::size_t>(g)].tile(t).component(c), shape.plane, rest);
    }
    for_each_cell<2>(shape, 0, [&](const Index<2>& cell) {
      const ElasticState state = state_of_cell(initial, g, t, cell, time);
      for (int c = 0; c < components(); ++c)
        field(g).tile(t).component(c)[shape.at(cell)] = state[static_cast<std::size_t>(c)];
    });
  });
  resume(time);
  for_each_tile([&](int g, int t) {
    rates_[static_cast<std::size_t>(g)][static_cast<std::size_t>(t)] = elastic_rate(view(g, t), setup_.options).rate;
  });
  if (const std::string bad = first_bad_cell(now_, false); !bad.empty())
    throw NumericalError("the state of solid " + setup_.name + " is not admissible at t = 0: " + bad);
}

void ElasticSolver::resume(double time) {
  if (overlap_) {
    const auto scope = timers_("overlap");
    overlap_->update({Pose<2>{}}, true);
    if (const OverlapReport& report = overlap_->report(); report.orphans > 0)
      throw NumericalError("the overlap of solid " + setup_.name + " has " + std::to_string(report.orphans) +
                           " cells without a donor, the first in " + report.first_orphan);
    fill_holes();
  }
  fill_ghosts(time);
  for_each_tile([&](int g, int t) {
    least_j_[static_cast<std::size_t>(g)][static_cast<std::size_t>(t)] =
        elastic_rate(view(g, t), setup_.options).least_j;
  });
}

void ElasticSolver::commit(double time) {
  for_each_tile([&](int g, int t) {
    const auto grid = static_cast<std::size_t>(g), tile = static_cast<std::size_t>(t);
    const bool advanced = computed_[grid][tile] != 0, changes = advanced || grids_[grid].masks[tile].cut();
    TileBlock& now = field(g).tile(t);
    if (changes && !memory_.holds.empty() && !std::exchange(memory_.holds[grid][tile], std::uint8_t{1}))
      keep(now, memory_.fields[grid].tile(t), advanced);
    if (advanced) std::swap(now, next_[grid].tile(t));
  });
  rates_ = new_rates_;
  least_j_ = new_least_j_;
  if (overlap_) interpolate();
  fill_ghosts(time);
}

/// Of the tiles, each is left in memory_ by the first commit() that changes it.
void ElasticSolver::remember() {
  if (memory_.fields.empty())
    for (Field<2>& next : next_) {
      Field<2>& field = memory_.fields.emplace_back(next.shape(), components(), next.tiles());
      for (int t = 0; t < field.tiles(); ++t) std::ranges::copy(next.tile(t).all(), field.tile(t).all().begin());
    }
  memory_.holds.clear();
  for (const Field<2>& field : now_)
    memory_.holds.emplace_back(static_cast<std::size_t>(field.tiles()), std::uint8_t{0});
  memory_.rates = rates_;
  memory_.least_j = least_j_;
  memory_.time = time_;
}

void ElasticSolver::go_back() {
  for_each_tile([&](int g, int t) {
    const auto grid = static_cast<std::size_t>(g), tile = static_cast<std::size_t>(t);
    if (std::exchange(memory_.holds[grid][tile], std::uint8_t{0}))
      std::swap(field(g).tile(t), memory_.fields[grid].tile(t));
  });
  rates_ = memory_.rates;
  least_j_ = memory_.least_j;
  fill_ghosts(memory_.time);
}

/// Fringe cells from their donors; deviations from rest are interpolated, so that a solid at rest stays so to the bit.
void ElasticSolver::interpolate() {
  {
    const auto scope = timers_("ghosts");
    for (std::size_t g = 0; g < grids_.size(); ++g)
      exchanges_[g].fill(now_[g], rest_, overlap_->donor_tiles(static_cast<int>(g)));
  }
  const auto scope = timers_("interpolation");
  const auto fill = [&]<int Components>() {
    overlap_->fill<Components>(
        now_,
        [&](const double* U, double* W) {
          for (std::size_t c = 0; c < Components; ++c) W[c] = U[c] - rest_[c];
        },
        [&](const double* W, double* U) {
          for (std::size_t c = 0; c < Components; ++c) U[c] = W[c] + rest_[c];
        });
  };
  if (components() == 7)
    fill.template operator()<7>();
  else
    fill.template operator()<8>();
}

/// Hole cells are at rest, so that nothing depends on what they held; in both fields, for they are never advanced.
void ElasticSolver::fill_holes() {
  for_each_tile([&](int g, int t) {
    const TileMask& mask = grid_of(g).masks[static_cast<std::size_t>(t)];
    if (!mask.cut()) return;
    const TileShape<2>& shape = grid_of(g).shape;
    for_each_cell<2>(shape, 0, [&](const Index<2>& cell) {
      if (mask.state[shape.at(cell)] != CellState::hole) return;
      for (int c = 0; c < components(); ++c)
        for (Field<2>* of : {&now_[static_cast<std::size_t>(g)], &next_[static_cast<std::size_t>(g)]})
          of->tile(t).component(c)[shape.at(cell)] = rest_[static_cast<std::size_t>(c)];
    });
  });
}

double ElasticSolver::rate() const {
  double fastest = 0;
  for (const std::vector<double>& of_grid : rates_)
    for (const double rate : of_grid) fastest = std::max(fastest, rate);
  return comm_.max(fastest);
}

double ElasticSolver::least_j() const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& of_grid : least_j_)
    for (const double j : of_grid) least = std::min(least, j);
  return comm_.min(least);
}

std::size_t ElasticSolver::memory_bytes() const {
  std::size_t bytes = 0;
  for_each_tile([&](int g, int t) {
    bytes += now_[static_cast<std::size_t>(g)].tile(t).bytes() + next_[static_cast<std::size_t>(g)].tile(t).bytes();
  });
  for (const Field<2>& field : memory_.fields)
    for (int t = 0; t < field.tiles(); ++t) bytes += field.tile(t).bytes();
  return bytes;
}

}  // namespace mortise
