// The step of an elastic solid: what its boundaries do, which tiles are computed, and the kernel's view of each.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mortise/solid/elastic_solver.hpp"

namespace mortise {

/// The kernel's view of a tile, no side prescribed.
ElasticTile ElasticSolver::view(int g, int t) {
  const auto grid = static_cast<std::size_t>(g), tile = static_cast<std::size_t>(t);
  ElasticTile view;
  view.shape = &grids_[grid].shape;
  view.now = now_[grid].tile(t).component(0);
  view.next = next_[grid].tile(t).component(0);
  const TileMask& mask = grids_[grid].masks[tile];
  view.active = mask.cut() ? mask.active.data() : nullptr;
  if (grids_[grid].background()) {
    view.spacing = {grids_[grid].spacing.x(), grids_[grid].spacing.y()};
  } else {
    view.nodes = &node_shapes_[grid];
    view.x = nodes_[grid][tile][0].data();
    view.y = nodes_[grid][tile][1].data();
  }
  return view;
}

/// (t*, v*) on the sides of a tile that are boundaries of the solid, except interfaces, at time + ½ dt.
void ElasticSolver::solve_boundaries(int g, int t, ElasticTile& view, double dt) {
  for (const Side side : {Side::west, Side::east, Side::south, Side::north}) {
    const ElasticSide* what = boundary(g, t, side);
    const bool prescribed = what && (what->kind == ElasticBoundary::displacement ||
                                     what->kind == ElasticBoundary::traction || what->kind == ElasticBoundary::slip);
    if (prescribed) solve_boundary(g, t, side, *what, view, dt);
  }
}

void ElasticSolver::solve_boundary(int g, int t, Side side, const ElasticSide& what, ElasticTile& view, double dt) {
  const auto s = static_cast<std::size_t>(side);
  const bool upright = side == Side::west || side == Side::east;
  const Index<2>& cells = view.shape->cells;
  const int faces = cells[upright ? 1 : 0];
  traces_.resize(static_cast<std::size_t>(faces));
  elastic_traces(view, side, dt, setup_.options, traces_.data());
  traction_[s].resize(traces_.size());
  velocity_[s].resize(traces_.size());
  const int beside = side == Side::east ? cells[0] : side == Side::north ? cells[1] : 0;  // column or row of nodes
  for (int k = 0; k < faces; ++k) {
    const auto node = [&](int along) {
      return upright ? tile_node(g, t, beside, along) : tile_node(g, t, along, beside);
    };
    const auto face = static_cast<std::size_t>(k);
    const BoundarySolution solution =
        boundary_solution(what, traces_[face], boundary_face(node(k), node(k + 1), side), time_ + 0.5 * dt);
    traction_[s][face] = solution.traction;
    velocity_[s][face] = solution.velocity;
  }
  view.sides[s] = {traction_[s].data(), velocity_[s].data()};
}

std::vector<ElasticTrace> ElasticSolver::interface_traces(double dt) {
  using Numbers = std::array<double, 16>;
  struct Item {
    int face;
    Numbers trace;
  };
  std::vector<Item> mine;
  for_each_tile([&](int g, int t) {
    const ElasticSide* south = boundary(g, t, Side::south);
    if (!south || south->kind != ElasticBoundary::interface) return;
    const ElasticTile tile = view(g, t);
    traces_.resize(static_cast<std::size_t>(tile.shape->cells[0]));
    elastic_traces(tile, Side::south, dt, setup_.options, traces_.data());
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      const ElasticTrace& a = traces_[i];
      mine.push_back({grid_of(g).first_cell(t)[0] + static_cast<int>(i),
                      {a.velocity[0], a.velocity[1], a.traction[0], a.traction[1], a.velocity_now[0], a.velocity_now[1],
                       a.traction_now[0], a.traction_now[1], a.tangent[0], a.tangent[1], a.tangent_now[0], a.tangent_now[1],
                       a.admittance(0, 0), a.admittance(0, 1), a.admittance(1, 0), a.admittance(1, 1)}});
    }
  });
  std::vector<Item> all = comm_.gather_all(mine);
  std::sort(all.begin(), all.end(), [](const Item& a, const Item& b) { return a.face < b.face; });
  std::vector<ElasticTrace> traces;
  for (const auto& [face, a] : all) {
    ElasticTrace trace{{a[0], a[1]}, {a[2], a[3]}, {a[4], a[5]}, {a[6], a[7]}, {a[8], a[9]}, {a[10], a[11]}, {}};
    trace.admittance << a[12], a[13], a[14], a[15];
    traces.push_back(trace);
  }
  return traces;
}

bool ElasticSolver::step(const std::vector<Point<2>>& traction, const std::vector<Point<2>>& velocity, double dt) {
  const auto scope = timers_("solid");
  count_ = {};
  new_rates_ = rates_;
  new_least_j_ = least_j_;
  bool admissible = true;
  for_each_tile([&](int g, int t) {
    const auto grid = static_cast<std::size_t>(g), tile = static_cast<std::size_t>(t);
    const TileMask& mask = grids_[grid].masks[tile];
    const int active = mask.cut() ? mask.active_count : grids_[grid].shape.count();
    computed_[grid][tile] = 0;
    if (active == 0 && mask.hole) return;
    ElasticTile view_of = view(g, t);
    solve_boundaries(g, t, view_of, dt);
    const ElasticSide* south = boundary(g, t, Side::south);
    if (south && south->kind == ElasticBoundary::interface) {
      const int first = grids_[grid].first_cell(t)[0];
      view_of.sides[static_cast<std::size_t>(Side::south)] = {traction.data() + first, velocity.data() + first};
    }
    if (setup_.skip && quiet(g, t, view_of)) {
      count_.skipped += active;
      return;
    }
    const ElasticStepResult result = elastic_step(view_of, dt, setup_.options);
    computed_[grid][tile] = 1;
    new_rates_[grid][tile] = result.rate;
    new_least_j_[grid][tile] = result.least_j;
    admissible = admissible && result.admissible;
    count_.computed += active;
  });
  return !comm_.any(!admissible);
}

/// One state without velocity in all cells and ghosts, and nothing at the boundaries: the step would change no bit.
/// Under stress that holds only where the faces of every cell cancel exactly: on Cartesian tiles without prescribed
/// sides.
bool ElasticSolver::quiet(int g, int t, const ElasticTile& view_of) const {
  const TileShape<2>& shape = *view_of.shape;
  const TileBlock& block = now_[static_cast<std::size_t>(g)].tile(t);
  const int ghosts = TileShape<2>::ghosts, width = shape.cells[0] + 2 * ghosts;
  bool stressed = false;
  for (int c = 0; c < components(); ++c) {
    const double value = block.component(c)[shape.at(0, 0)], rest = rest_[static_cast<std::size_t>(c)];
    if (c < 2 && value != 0) return false;
    stressed = stressed || (c < displacement_component(law()) && value != rest);
    for (int j = -ghosts; j < shape.cells[1] + ghosts; ++j) {
      const double* row = block.component(c) + shape.at(-ghosts, j);
      if (!std::all_of(row, row + width, [value](double a) { return a == value; })) return false;
    }
  }
  const auto at_rest = [&](std::size_t s) {
    const SideFlux& side = view_of.sides[s];
    const auto faces = static_cast<std::size_t>(shape.cells[s < 2 ? 1 : 0]);
    const auto zero = [](const Point<2>& a) { return a[0] == 0 && a[1] == 0; };
    return !side.present() || (!stressed && std::all_of(side.traction, side.traction + faces, zero) &&
                               std::all_of(side.velocity, side.velocity + faces, zero));
  };
  if (stressed && (view_of.x || view_of.active)) return false;
  return at_rest(0) && at_rest(1) && at_rest(2) && at_rest(3);
}

std::string ElasticSolver::first_bad_cell() const { return first_bad_cell(next_, true); }

std::string ElasticSolver::first_bad_cell(const std::vector<Field<2>>& fields, bool computed_only) const {
  struct Found {
    std::int64_t grid, tile;  // global
    std::array<char, 320> text;
  };
  std::vector<Found> mine;
  for_each_tile([&](int g, int t) {
    const auto grid = static_cast<std::size_t>(g);
    if (!mine.empty() || (computed_only && !computed_[grid][static_cast<std::size_t>(t)])) return;
    const std::string text = bad_cell_of_tile(g, t, fields[grid].tile(t));
    if (text.empty()) return;
    mine.push_back({g, grids_[grid].forest.first_global() + t, {}});
    text.copy(mine.back().text.data(), mine.back().text.size() - 1);
  });
  const std::vector<Found> all = comm_.gather_all(mine);
  const auto first = std::min_element(all.begin(), all.end(), [](const Found& a, const Found& b) {
    return std::pair(a.grid, a.tile) < std::pair(b.grid, b.tile);
  });
  return first == all.end() ? "" : std::string(first->text.data());
}

std::string ElasticSolver::bad_cell_of_tile(int g, int t, const TileBlock& block) const {
  const ComponentGrid<2>& grid = grid_of(g);
  const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
  std::string found;
  for_each_cell<2>(grid.shape, 0, [&](const Index<2>& cell) {
    const std::size_t k = grid.shape.at(cell);
    if (!found.empty() || (mask.cut() && !mask.active[k])) return;
    ElasticState a{};
    for (int c = 0; c < components(); ++c) a[static_cast<std::size_t>(c)] = block.component(c)[k];
    const bool linear = law() == StressLaw::linear;
    const double J = linear ? 1 : a[2] * a[5] - a[3] * a[4];
    if (J > 0 && std::all_of(a.begin(), a.end(), [](double value) { return std::isfinite(value); })) return;
    const Index<2> first = grid.first_cell(t);
    std::ostringstream text;
    text << "grid " << grid.name << ", cell (" << first[0] + cell[0] << ", " << first[1] + cell[1] << ") at ("
         << cell_center(g, t, cell).transpose() << "): ";
    if (linear)
      text << "stress " << a[2] << ' ' << a[3] << ' ' << a[4];
    else
      text << "J " << J << ", F " << a[2] << ' ' << a[3] << ' ' << a[4] << ' ' << a[5];
    text << ", velocity " << a[0] << ' ' << a[1];
    found = text.str();
  });
  return found;
}

}  // namespace mortise
