#include "mortise/coupler/reference_map/flow_solids.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mortise/coupler/reference_map/solid_edges.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

void check(const FlowSolidsSetup& setup) {
  for (const FlowBody& body : setup.bodies) {
    const auto refuse = [&](const char* what, double value) {
      throw InputError("solid " + body.name + ": its " + what + " is " + std::to_string(value) + ", it must be > 0");
    };
    if (!(body.density > 0)) refuse("density", body.density);
    if (!(body.shear_modulus > 0)) refuse("shear modulus", body.shear_modulus);
    if (!(body.viscosity >= 0)) throw InputError("solid " + body.name + ": its viscosity must not be negative");
  }
}

constexpr double restoring = 0.05;  // rate at which drifted volumes come back, in parts of the fastest rate

/// Where an anchor takes its material: x = origin + turn (ξ − center), and the rate of that.
struct Motion {
  Point<2> origin;
  Eigen::Matrix2d turn;
};
Motion motion_of(const Anchor& anchor, double time) {
  return {anchor.center + (anchor.shift ? anchor.shift(time) : Point<2>(0, 0)),
          Eigen::Rotation2Dd(anchor.angle ? anchor.angle(time) : 0).toRotationMatrix()};
}

}  // namespace

FlowSolids::FlowSolids(FlowSolidsSetup setup, const ComponentGrid<2>& grid)
    : setup_(std::move(setup)), grid_(grid), written_(static_cast<std::size_t>(grid.forest.local_count())) {
  check(setup_);
  for (const FlowBody& body : setup_.bodies) {
    BodyMap::Setup map{body.name, SolidLaw{body.density, 0, body.shear_modulus, 0, 2, true}, body.level_set,
                       body.reference};
    // Edges with a share of the solid lie within blur + ½ cells, their stencils within 1.2 more; the half step needs
    // one layer more than it keeps.
    map.layers = static_cast<int>(std::ceil(setup_.blur + 2.5)) + 1;
    map.keeps_volume = true;
    if (!map.initial) map.initial = [](const Point<2>& x) { return x; };
    maps_.push_back(std::make_unique<BodyMap>(std::move(map), grid));
  }
  // Shear waves on a compact stencil in two directions. s G/(ρ_f + s (ρ_s − ρ_f)) is largest where s = 1.
  const double h = grid.spacing.minCoeff();
  for (const FlowBody& body : setup_.bodies)
    fastest_ = std::max(fastest_, std::sqrt(2 * body.shear_modulus / body.density) / h);
}

double FlowSolids::rate() const { return fastest_; }

std::int64_t FlowSolids::orphans() const {
  std::int64_t sum = 0;
  for (const auto& map : maps_) sum += map->orphans();
  return sum;
}

void FlowSolids::begin(SolidFields& fields) {
  for (const auto& map : maps_)
    if (!map->initialize())
      throw InputError("solid " + map->name() + ": its displacement at t = 0 turns it inside out");
  for (std::size_t a = 0; a < maps_.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      bool overlap = false;
      for (int t = 0; t < grid_.forest.local_count(); ++t) {
        const TileBlock &one = maps_[a]->field().tile(t), &two = maps_[b]->field().tile(t);
        if (!one.allocated() || !two.allocated()) continue;
        for_each_cell<2>(grid_.shape, 0, [&](const Index<2>& c) {
          const std::size_t k = grid_.shape.at(c);
          overlap = overlap || (one.component(2)[k] < 0 && two.component(2)[k] < 0);
        });
      }
      if (grid_.forest.communicator().any(overlap))
        throw InputError("solids " + maps_[b]->name() + " and " + maps_[a]->name() + " overlap at t = 0");
    }
  write(false, 0, fields);
}

void FlowSolids::drift(bool to_half, double time) {
  const auto velocity = [&](int t) {
    const std::size_t first = grid_.shape.at(0, 0);
    const TileBlock& v = velocity_->tile(t);
    return TileVelocity{v.component(0) + first, v.component(1) + first};
  };
  for (const auto& map : maps_)
    if (!(to_half ? map->drift_to_half(time, velocity) : map->drift_to_end(time, velocity)))
      throw NumericalError("solid " + map->name() + " turns inside out");
}

void FlowSolids::half_step(const EdgeVelocities&, double time, double dt, SolidFields& fields) {
  last_step_ = dt;
  if (dt == 0 || !velocity_) return;
  drift(true, 0.5 * dt);
  write(true, time + 0.5 * dt, fields);
}

void FlowSolids::full_step(const Field<2>& velocity, double time, SolidFields& fields) {
  velocity_ = &velocity;
  if (last_step_ > 0) drift(false, 0.5 * last_step_);
  write(false, time, fields);
}

void FlowSolids::write(bool half, double time, SolidFields& fields) {
  for (int t = 0; t < grid_.forest.local_count(); ++t) write_tile(t, half, time, fields);
}

void FlowSolids::write_tile(int t, bool half, double time, SolidFields& fields) {
  std::vector<EdgeBody> bodies;
  TileWindow around;
  for (std::size_t b = 0; b < maps_.size(); ++b) {
    const TileBlock& map = (half ? maps_[b]->half() : maps_[b]->field()).tile(t);
    if (!map.allocated()) continue;
    bodies.push_back({&setup_.bodies[b], &map, maps_[b]->window(t, half), maps_[b]->folded()});
    around = around | bodies.back().window;
  }
  // Of windows that reach into a tile's ghosts the tile has edges along its far sides.
  TileWindow& written = written_[static_cast<std::size_t>(t)];
  reset(t, written | around, fields);
  written = around;
  const EdgeSolids edges{&grid_,         t,    setup_.blur * grid_.spacing.minCoeff(),    setup_.fluid_viscosity,
                         setup_.damping, time, velocity_ ? &velocity_->tile(t) : nullptr, &fields};
  for (const EdgeBody& body : bodies) {
    const TileWindow cells = body.window & tile_cells(grid_.shape);
    add_volume(t, *body.body, *body.map, cells, fields);
    for (const Anchor& anchor : body.body->anchors) add_anchor(t, *body.body, anchor, time, *body.map, cells, fields);
    add_elastic(edges, body);
    if (body.folded) add_self_contact(edges, body);
    for (const EdgeBody& other : bodies)
      if (other.body != body.body && !(body.window & other.window).empty()) add_contact(edges, body, other);
    for (std::size_t side = 0; side < 4; ++side)
      if (setup_.walls[side] && near_side(t, side, body.window)) add_wall_push(edges, body, side);
  }
}

/// The wall's push reaches into the window.
bool FlowSolids::near_side(int t, std::size_t side, const TileWindow& window) const {
  const std::size_t d = side / 2;
  const int first = grid_.first_cell(t)[d], far = static_cast<int>(std::ceil(3 * setup_.blur)) + 1;
  return side % 2 ? first + window.high[d] > grid_.cells[d] - far : first + window.low[d] < far;
}

/// To what the fluid alone has.
void FlowSolids::reset(int t, const TileWindow& window, SolidFields& fields) const {
  if (window.empty()) return;
  const auto width = static_cast<std::size_t>(window.high[0] - window.low[0]);
  const auto fill = [&](Field<2>& field, int components, double value) {
    for (int c = 0; c < components; ++c)
      for (int j = window.low[1]; j < window.high[1]; ++j)
        std::fill_n(field.tile(t).component(c) + grid_.shape.at(window.low[0], j), width, value);
  };
  fill(fields.density, 1, setup_.fluid_density);
  fill(fields.divergence, 1, 0.0);
  fill(fields.viscosity, 2, setup_.fluid_viscosity);
  for (Field<2>* field : {&fields.stress_x, &fields.stress_y, &fields.force}) fill(*field, 2, 0.0);
}

/// Density, and the divergence that brings det ∂ξ/∂x back to 1, since no stress does that in a liquid; not beside the
/// surface, where it would draw liquid in.
void FlowSolids::add_volume(int t, const FlowBody& body, const TileBlock& map, const TileWindow& window,
                            SolidFields& fields) const {
  const double width = setup_.blur * grid_.spacing.minCoeff(), inverse_width = 1 / width;
  const double excess = body.density - setup_.fluid_density, rate = restoring * fastest_;
  const std::ptrdiff_t s = grid_.shape.stride;
  for (int j = window.low[1]; j < window.high[1]; ++j)
    for (int i = window.low[0]; i < window.high[0]; i += simd_width) {
      const std::size_t k = grid_.shape.at(i, j);
      const Pack phi = load(map.component(2) + k), share = solid_share(phi, inverse_width);
      const PackMask own = lanes_below(window.high[0] - i) & (share > 0);
      if (!any(own)) continue;
      double *const density = fields.density.tile(t).component(0) + k, *const divergence =
                                                                           fields.divergence.tile(t).component(0) + k;
      store(density, load(density) + select(own, Pack(share * excess), Pack{}));
      const Pack deep = solid_share(phi + width, inverse_width);
      const Pack excess_of_det =
          min(max(map_determinant(map, k, s, grid_.spacing) - 1.0, broadcast(-0.5)), broadcast(0.5));
      store(divergence, load(divergence) + select(own & (deep > 0), Pack((rate * deep) * excess_of_det), Pack{}));
    }
}

void FlowSolids::add_anchor(int t, const FlowBody& body, const Anchor& anchor, double time, const TileBlock& map,
                            const TileWindow& window, SolidFields& fields) const {
  const double instant = 1e-5, stiffness = fastest_ * fastest_;  // per mass
  const Motion now = motion_of(anchor, time), before = motion_of(anchor, time - instant),
               after = motion_of(anchor, time + instant);
  const double inverse_width = 1 / (setup_.blur * grid_.spacing.minCoeff());
  const Index<2> first = grid_.first_cell(t);
  for (int j = window.low[1]; j < window.high[1]; ++j)
    for (int i = window.low[0]; i < window.high[0]; ++i) {
      const std::size_t k = grid_.shape.at(i, j);
      if (!(map.component(3)[k] < unknown_layer)) continue;
      const Point<2> arm = Point<2>(map.component(0)[k], map.component(1)[k]) - anchor.center;
      const double share =
          solid_share(arm.norm() - anchor.radius, inverse_width) * solid_share(map.component(2)[k], inverse_width);
      if (share == 0) continue;
      const Point<2> x = grid_.center({first[0] + i, first[1] + j});
      const Point<2> rate = (after.origin - before.origin + (after.turn - before.turn) * arm) / (2 * instant);
      Point<2> v = rate;
      if (velocity_) v = {velocity_->tile(t).component(0)[k], velocity_->tile(t).component(1)[k]};
      const Point<2> pull = stiffness * (now.origin + now.turn * arm - x) + std::sqrt(stiffness) * (rate - v);
      for (int c = 0; c < 2; ++c) fields.force.tile(t).component(c)[k] += share * body.density * pull[c];
    }
}

}  // namespace mortise
