// Scenes without background for tests: gas on one mesh whose nodes are a given function of time.
#pragma once

#include <functional>
#include <memory>
#include <numbers>

#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/euler_solver.hpp"
#include "mortise/fluid/wall_areas.hpp"
#include "mortise/fluid/wall_pressure.hpp"
#include "unit/fluid/plane_tiles.hpp"

namespace mortise::testing {

struct MovingMesh {
  int along, layers;
  bool periodic;
  Point<2> period;
  std::function<Point<2>(int i, int j, double t)> node;

  std::shared_ptr<const GrownGrid> at(double t) const {
    GrownGrid grid{.along = along, .layers = layers, .spacing = 1.0 / layers, .nodes = {}, .periodic = periodic, .period = period};
    for (int j = 0; j <= layers; ++j)
      for (int i = 0; i < grid.row(); ++i) grid.nodes.push_back(node(i, j, t));
    return std::make_shared<const GrownGrid>(std::move(grid));
  }
};

/// Smooth displacement without symmetry, of period 1 in x and, as the reciprocal of a cell size permits, well below a cell.
inline Point<2> wobble(const Point<2>& X, double t) {
  constexpr double turn = 2 * std::numbers::pi;
  return {0.02 * std::sin(turn * X[0] + 3 * X[1] + 2.3 * t + 1) + 0.01 * std::cos(2 * turn * X[0] - 5 * X[1] + 4.1 * t),
          0.02 * std::cos(turn * X[0] - 4 * X[1] + 3.1 * t) + 0.01 * std::sin(2 * turn * X[0] + 2 * X[1] - 1.7 * t + 2)};
}

/// The unit square; every node wobbles by `strength` times the displacement above.
inline MovingMesh wobbling_square(int along, int layers, bool periodic, double strength = 1) {
  return {along, layers, periodic, periodic ? Point<2>(1, 0) : Point<2>(0, 0), [=](int i, int j, double t) -> Point<2> {
            const Point<2> X(static_cast<double>(i) / along, static_cast<double>(j) / layers);
            return X + strength * wobble(X, t);
          }};
}

/// A ring around the origin between the radii 1/2 and 1, clockwise; every node wobbles by `strength`, at the outer edge by
/// `strength_outside`.
inline MovingMesh wobbling_ring(int along, int layers, double strength_outside) {
  return {along, layers, true, Point<2>(0, 0), [=](int i, int j, double t) -> Point<2> {
            const double outward = static_cast<double>(j) / layers, angle = -2 * std::numbers::pi * i / along;
            const Point<2> X(static_cast<double>(i) / along, outward);
            const Point<2> edge = (0.5 + 0.5 * outward) * Point<2>(std::cos(angle), std::sin(angle));
            return edge + (1 - outward * (1 - strength_outside)) * wobble(X, t);
          }};
}

/// Pressure on wall faces that move from `start` to `end` over dt, by the piston relation.
inline std::vector<double> piston_pressure(const std::vector<WallTrace<2>>& traces, const GrownGrid& start, const GrownGrid& end, double dt) {
  const std::vector<Point<2>> areas = wall_areas(start, end);
  std::vector<double> pressure;
  for (int i = 0; i < start.along; ++i) {
    const Point<2> normal = areas[static_cast<std::size_t>(i)].normalized();
    const Point<2> moved = 0.5 * (end.node(i, 0) - start.node(i, 0) + end.node(i + 1, 0) - start.node(i + 1, 0));
    const Primitive<2>& gas = traces[static_cast<std::size_t>(i)].half;
    const Point<2> slip = moved / dt - Point<2>(gas.velocity[0], gas.velocity[1]);
    pressure.push_back(wall_response(gas.density, gas.pressure, slip.dot(normal), gamma_air).pressure);
  }
  return pressure;
}

/// The path of one body whose grid deforms.
inline std::vector<BodyPath<2>> path_to(std::shared_ptr<const GrownGrid> mesh) {
  BodyPath<2> path;
  path.end_mesh = std::move(mesh);
  return {path};
}

class MeshRun {
 public:
  using Sides = std::array<BoundaryKind, 4>;

  MeshRun(MovingMesh mesh, bool wall, const Sides& sides, StateFunction<2> exact, Index<2> tile = {0, 0}, StepOptions options = {},
          const Communicator& comm = Communicator())
      : mesh_(std::move(mesh)), now_(mesh_.at(0)), solver_(comm, setup(wall, sides, exact, tile, options), timers_) {
    solver_.initialize(exact, path_to(now_), 0);
    solver_.measure_rates(path_to(mesh_.at(instant)), instant);
  }

  MeshRun(const MeshRun&) = delete;
  MeshRun& operator=(const MeshRun&) = delete;

  /// One step at CFL 0.9 that does not pass `limit`.
  void step(double limit = 1e300) { step_by(std::min(0.9 / solver_.rate(), limit - time_)); }
  void step_by(double dt) {
    const auto next = mesh_.at(time_ + dt);
    const std::vector<BodyPath<2>> paths = path_to(next);
    const auto traces = solver_.wall_traces(paths, dt);
    pressure_ = traces[0].empty() ? std::vector<double>{} : piston_pressure(traces[0], *now_, *next, dt);
    admissible_ = solver_.step(paths, {pressure_}, dt) && admissible_;
    time_ += dt;
    solver_.commit(paths, time_);
    before_ = now_;
    now_ = next;
  }
  void run(double end) {
    while (time_ < end) step(end);
  }

  /// Calls visit(centre, volume, state) for all cells of this rank.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t g = 0; g < solver_.grids().size(); ++g)
      for (int t = 0; t < solver_.fields()[g].tiles(); ++t)
        for_each_cell<2>(solver_.grids()[g].shape, 0, [&](const Index<2>& c) {
          visit(solver_.cell_center(0, t, c), solver_.cell_volume(0, t, c), get<2>(solver_.fields()[g].tile(t), solver_.grids()[g].shape.at(c)));
        });
  }
  /// Mass and energy.
  Point<2> totals() const {
    Point<2> sum(0, 0);
    for_each([&](const Point<2>&, double volume, const Conserved<2>& U) { sum += volume * Point<2>(U.density, U.energy); });
    return sum;
  }
  /// Largest difference of a cell from a function of position.
  double largest_difference(const StateFunction<2>& exact) const {
    double largest = 0;
    for_each([&](const Point<2>& x, double, const Conserved<2>& U) {
      largest = std::max(largest, distance(to_conserved(exact(x, time_), gamma_air), U));
    });
    return largest;
  }
  /// Densities of all cells of the mesh, row by row.
  std::vector<double> densities() const {
    struct Item {
      int place;
      double density;
    };
    const ComponentGrid<2>& grid = solver_.grids()[0];
    std::vector<Item> mine;
    for (int t = 0; t < solver_.fields()[0].tiles(); ++t) {
      const Index<2> first = grid.first_cell(t);
      for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
        mine.push_back({(first[1] + c[1]) * grid.cells[0] + first[0] + c[0], solver_.fields()[0].tile(t).component(0)[grid.shape.at(c)]});
      });
    }
    std::vector<double> all(static_cast<std::size_t>(grid.cells[0] * grid.cells[1]));
    for (const Item& item : solver_.communicator().gather_all(mine)) all[static_cast<std::size_t>(item.place)] = item.density;
    return all;
  }

  EulerSolver<2>& solver() { return solver_; }
  const GrownGrid& mesh() const { return *now_; }
  const GrownGrid& mesh_before() const { return *before_; }
  const std::vector<double>& pressure() const { return pressure_; }
  double time() const { return time_; }
  bool admissible() const { return admissible_; }

 private:
  static constexpr double instant = 1e-9;

  EulerSetup<2> setup(bool wall, const Sides& sides, const StateFunction<2>& exact, Index<2> tile, const StepOptions& options) const {
    EulerSetup<2> setup;
    setup.gas.gamma = gamma_air;
    setup.options = options;
    setup.boundaries.exact = exact;
    setup.boundaries.inflow = exact(Point<2>::Zero(), 0);
    setup.tile = tile;
    setup.bodies.resize(1);
    setup.bodies[0].name = "body";
    setup.bodies[0].wall = wall;
    setup.bodies[0].mesh = now_;
    setup.bodies[0].sides = sides;
    return setup;
  }

  MovingMesh mesh_;
  std::shared_ptr<const GrownGrid> now_, before_;
  PhaseTimers timers_;
  EulerSolver<2> solver_;
  std::vector<double> pressure_;
  double time_ = 0;
  bool admissible_ = true;
};

inline constexpr MeshRun::Sides around_and_wall = {BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::wall, BoundaryKind::wall};
inline constexpr MeshRun::Sides around_and_exact = {BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::wall, BoundaryKind::exact};
inline constexpr MeshRun::Sides all_exact = {BoundaryKind::exact, BoundaryKind::exact, BoundaryKind::wall, BoundaryKind::exact};

}  // namespace mortise::testing
