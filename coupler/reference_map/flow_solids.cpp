#include "mortise/coupler/reference_map/flow_solids.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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
  }
}

// Part of half the impedance with which velocities that differ across an edge pull at each other.
constexpr double smoothing = 0.05;

struct Stress {
  double xx, xy, yy;
};

/// τ of the elastic part of the deformation, F F_a⁻¹; `stretch` is a of F_a = Rᵀ diag(a, 1/a) R, c and s: of R.
Stress neo_hookean(const MapGradient<double>& G, double modulus, double stretch, double c, double s) {
  // With H = diag(a, 1/a) R G the elastic left Cauchy-Green tensor is b = (HᵀH)⁻¹.
  const double xx = stretch * (c * G.xx + s * G.yx), xy = stretch * (c * G.xy + s * G.yy);
  const double yx = (c * G.yx - s * G.xx) / stretch, yy = (c * G.yy - s * G.xy) / stretch;
  const double det = xx * yy - xy * yx, inverse = 1 / (det * det);
  const double bxx = inverse * (xy * xy + yy * yy), byy = inverse * (xx * xx + yx * yx),
               bxy = -inverse * (xx * xy + yx * yy);
  const double mean = (bxx + byy + 1) / 3;
  return {modulus * (bxx - mean), modulus * bxy, modulus * (byy - mean)};
}

}  // namespace

FlowSolids::FlowSolids(FlowSolidsSetup setup, const ComponentGrid<2>& grid)
    : setup_(std::move(setup)), grid_(grid), written_(static_cast<std::size_t>(grid.forest.local_count()), 0) {
  check(setup_);
  for (const FlowBody& body : setup_.bodies) {
    BodyMap::Setup map{body.name, SolidLaw{body.density, 0, body.shear_modulus, 0, 2, true}, body.level_set,
                       body.reference};
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
  for (int t = 0; t < grid_.forest.local_count(); ++t) {
    const auto on = [&](const auto& map) { return (half ? map->half() : map->field()).tile(t).allocated(); };
    std::uint8_t& written = written_[static_cast<std::size_t>(t)];
    const bool covered = std::any_of(maps_.begin(), maps_.end(), on);
    if (!covered && !written) continue;
    written = covered;
    write_tile(t, half, time, fields);
  }
}

void FlowSolids::write_tile(int t, bool half, double time, SolidFields& fields) {
  const std::size_t plane = grid_.shape.plane;
  std::fill_n(fields.density.tile(t).component(0), plane, setup_.fluid_density);
  std::fill_n(fields.viscosity.tile(t).component(0), plane, setup_.fluid_viscosity);
  std::fill_n(fields.viscosity.tile(t).component(1), plane, setup_.fluid_viscosity);
  for (Field<2>* field : {&fields.stress_x, &fields.stress_y, &fields.force})
    for (int c = 0; c < 2; ++c) std::fill_n(field->tile(t).component(c), plane, 0.0);
  const double width = setup_.blur * grid_.spacing.minCoeff(), inverse_width = 1 / width;
  const Index<2> first = grid_.first_cell(t);
  for (std::size_t b = 0; b < maps_.size(); ++b) {
    const TileBlock& map = (half ? maps_[b]->half() : maps_[b]->field()).tile(t);
    if (!map.allocated()) continue;
    const FlowBody& body = setup_.bodies[b];
    const double stiffness = fastest_ * fastest_;  // of anchors, per mass
    double* const density = fields.density.tile(t).component(0);
    for (int j = 0; j < grid_.shape.cells[1]; ++j)
      for (int i = 0; i < grid_.shape.cells[0]; ++i) {
        const std::size_t k = grid_.shape.at(i, j);
        const double phi = map.component(2)[k];
        if (!(phi < width)) continue;
        const double share = solid_share(phi, inverse_width);
        density[k] += share * (body.density - setup_.fluid_density);
        if (phi >= 0) continue;
        const Point<2> xi(map.component(0)[k], map.component(1)[k]);
        for (const Anchor& anchor : body.anchors) {
          const Point<2> arm = xi - anchor.center;
          if (!(arm.norm() < anchor.radius)) continue;
          const auto target = [&](double at) -> Point<2> {
            const double angle = anchor.angle ? anchor.angle(at) : 0;
            const Point<2> moved = anchor.shift ? anchor.shift(at) : Point<2>(0, 0);
            return anchor.center + moved + Eigen::Rotation2Dd(angle) * arm;
          };
          const double instant = 1e-5;
          const Point<2> x = grid_.center({first[0] + i, first[1] + j}),
                         wanted = (target(time + instant) - target(time - instant)) / (2 * instant);
          Point<2> v = wanted;
          if (velocity_) v = {velocity_->tile(t).component(0)[k], velocity_->tile(t).component(1)[k]};
          const Point<2> pull = stiffness * (target(time) - x) + std::sqrt(stiffness) * (wanted - v);
          for (int c = 0; c < 2; ++c) fields.force.tile(t).component(c)[k] += share * body.density * pull[c];
        }
      }
    for (const int direction : {0, 1}) add_edges(t, direction, b, half, time, fields);
  }
}

/// Stress and viscosity on the edges before the cells of a tile, and on those at its far side.
void FlowSolids::add_edges(int t, int direction, std::size_t b, bool half, double time, SolidFields& fields) {
  const auto map_of = [&](std::size_t body) -> const TileBlock& {
    return (half ? maps_[body]->half() : maps_[body]->field()).tile(t);
  };
  const TileBlock& map = map_of(b);
  const FlowBody& body = setup_.bodies[b];
  const std::ptrdiff_t stride = grid_.shape.stride, back = direction == 0 ? 1 : stride,
                       across = direction == 0 ? stride : 1;
  const double width = setup_.blur * grid_.spacing.minCoeff(), inverse_width = 1 / width;
  const double along_step = 1 / grid_.spacing[direction], across_step = 0.25 / grid_.spacing[1 - direction];
  const double impedance = std::sqrt(body.density * body.shear_modulus);
  double* const viscosity = fields.viscosity.tile(t).component(direction);
  TileBlock& stress = (direction == 0 ? fields.stress_x : fields.stress_y).tile(t);
  const double cosine = std::cos(body.axis), sine = std::sin(body.axis);
  const Index<2> first = grid_.first_cell(t);
  const double *const x = map.component(0), *const y = map.component(1), *const phi = map.component(2),
                      *const layer = map.component(3);
  const int i_high = grid_.shape.cells[0] + (direction == 0), j_high = grid_.shape.cells[1] + (direction == 1);
  for (int j = 0; j < j_high; ++j)
    for (int i = 0; i < i_high; ++i) {
      const std::size_t k = grid_.shape.at(i, j), p = k - static_cast<std::size_t>(back);
      if (!(layer[k] < BodyMap::unknown && layer[p] < BodyMap::unknown)) continue;
      const double level = 0.5 * (phi[k] + phi[p]);
      if (!(level < width)) continue;
      const auto along = [&](const double* q) { return along_step * (q[k] - q[p]); };
      const auto s = static_cast<std::size_t>(across);
      const auto aside = [&](const double* q) { return across_step * (q[k + s] - q[k - s] + q[p + s] - q[p - s]); };
      MapGradient<double> G;
      if (direction == 0)
        G = {along(x), aside(x), along(y), aside(y)};
      else
        G = {aside(x), along(x), aside(y), along(y)};
      if (!(G.determinant() > 0.05)) continue;
      const double share = solid_share(level, inverse_width);
      const Point<2> X(0.5 * (x[k] + x[p]), 0.5 * (y[k] + y[p]));
      Stress tau = neo_hookean(G, body.shear_modulus, body.actuation ? body.actuation(X, time) : 1.0, cosine, sine);
      // ∇φ in space, for what pushes bodies apart.
      const auto slope = [&](const double* q) {
        const Point<2> g(along(q), aside(q));
        return direction == 0 ? g : Point<2>(g.y(), g.x());
      };
      const auto push = [&](Point<2> n, double amount) {
        const double size2 = n.squaredNorm();
        if (!(size2 > 0)) return;
        tau.xx -= amount * (n.x() * n.x() / size2 - 0.5);
        tau.xy -= amount * n.x() * n.y() / size2;
        tau.yy -= amount * (n.y() * n.y() / size2 - 0.5);
      };
      for (std::size_t other = 0; other < maps_.size(); ++other) {
        if (other == b || !map_of(other).allocated()) continue;
        const double* theirs = map_of(other).component(2);
        const double their_level = 0.5 * (theirs[k] + theirs[p]);
        if (!(their_level < width)) continue;
        const double modulus = std::min(body.shear_modulus, setup_.bodies[other].shear_modulus);
        push(slope(theirs) - slope(phi),
             4 * modulus * std::min(1 - level * inverse_width, 1 - their_level * inverse_width));
      }
      for (std::size_t side = 0; side < 4; ++side) {
        if (!setup_.walls[side]) continue;
        const int d = static_cast<int>(side / 2);
        const double at =
            grid_.origin[d] +
            (first[static_cast<std::size_t>(d)] + (d == 0 ? i : j) + (d == direction ? 0.0 : 0.5)) * grid_.spacing[d];
        const double end =
            grid_.origin[d] + (side % 2 ? grid_.cells[static_cast<std::size_t>(d)] * grid_.spacing[d] : 0.0);
        const double closeness = 1 - std::fabs(at - end) / (3 * width);
        if (closeness > 0) push(Point<2>::Unit(d), 4 * body.shear_modulus * closeness);
      }
      // Jump between the velocities that cells on both sides have at the edge by linear reconstruction, c their
      // component.
      const auto upwinding = [&](int c) {
        if (!velocity_) return 0.0;
        const double* v = velocity_->tile(t).component(c) + k;
        return smoothing * impedance * -0.25 * ((v[back] - *(v - 2 * back)) - 3 * (v[0] - *(v - back)));
      };
      stress.component(0)[k] += share * ((direction == 0 ? tau.xx : tau.xy) + upwinding(0));
      stress.component(1)[k] += share * ((direction == 0 ? tau.xy : tau.yy) + upwinding(1));
      viscosity[k] = std::max(0.0, viscosity[k] - share * setup_.fluid_viscosity);
    }
}

}  // namespace mortise
