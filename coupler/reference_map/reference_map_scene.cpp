#include "mortise/coupler/reference_map/reference_map_scene.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/fluid/cell.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr std::array<double, composition::count> no_solid{};

SolidLaw law_of(const MappedBody& body, double pressure, double gamma) {
  if (body.material.law == StressLaw::linear)
    throw InputError("solid " + body.name +
                     ": the reference map needs a law for finite strains, neo_hookean or saint_venant_kirchhoff");
  return {body.material.density,
          body.material.lambda,
          body.material.mu,
          pressure,
          gamma,
          body.material.law == StressLaw::neo_hookean};
}

}  // namespace

ReferenceMapScene::ReferenceMapScene(ReferenceMapSetup setup, EulerSolver<2>& fluid, PhaseTimers& timers)
    : setup_(std::move(setup)),
      fluid_(fluid),
      timers_(timers),
      composition_(Field<2>::unallocated(grid().shape, composition::count, grid().forest.local_count())),
      exchange_(grid().forest, grid().shape, composition::count) {
  for (const MappedBody& body : setup_.bodies)
    maps_.push_back(
        std::make_unique<BodyMap>(BodyMap::Setup{body.name, law_of(body, setup_.pressure, fluid.setup().gas.gamma),
                                                 body.level_set, body.reference},
                                  grid()));
  for (std::vector<double>& component : velocity_) component.assign(grid().shape.plane, 0.0);
  fluid_.set_stepper(this);
}

std::int64_t ReferenceMapScene::orphans() const {
  std::int64_t sum = 0;
  for (const auto& map : maps_) sum += map->orphans();
  return sum;
}

std::size_t ReferenceMapScene::memory_bytes() const {
  std::size_t bytes = 0;
  for (const auto& map : maps_) bytes += map->memory_bytes();
  for (int t = 0; t < composition_.tiles(); ++t) bytes += composition_.tile(t).bytes();
  return bytes;
}

bool ReferenceMapScene::covers(int tile) const {
  return std::any_of(maps_.begin(), maps_.end(), [&](const auto& map) {
    return map->field().tile(tile).allocated() || map->half().tile(tile).allocated();
  });
}

std::vector<TileBody> ReferenceMapScene::bodies_on(int tile, bool half) const {
  std::vector<TileBody> bodies;
  for (const auto& map : maps_) {
    const TileBlock& block = half ? map->half().tile(tile) : map->field().tile(tile);
    if (block.allocated()) bodies.push_back({&map->law(), &block});
  }
  return bodies;
}

CartesianTile<2> ReferenceMapScene::view(int tile) {
  double* const values = fluid_.fields().front().tile(tile).component(0);
  return {&grid().shape, values, values, {grid().spacing.x(), grid().spacing.y()}, nullptr};
}

MixtureTile ReferenceMapScene::mixture(const CartesianTile<2>& cells, int tile,
                                       std::span<const TileBody> bodies) const {
  return {cells, &composition_.tile(tile), bodies, setup_.blur, setup_.pressure};
}

BodyMap::Velocity ReferenceMapScene::velocities() {
  return [this](int tile) {
    const TileBlock& U = fluid_.fields().front().tile(tile);
    const std::size_t n = grid().shape.plane;
    for (int d = 0; d < 2; ++d) {
      const double *density = U.component(0), *momentum = U.component(1 + d);
      double* out = velocity_[d].data();
      for (std::size_t k = 0; k < n; ++k) out[k] = density[k] > 0 ? momentum[k] / density[k] : 0.0;
    }
    const std::size_t first = grid().shape.at(0, 0);
    return TileVelocity{velocity_[0].data() + first, velocity_[1].data() + first};
  };
}

void ReferenceMapScene::compose_all() {
  for (int t = 0; t < composition_.tiles(); ++t) {
    const std::vector<TileBody> bodies = bodies_on(t, false);
    if (bodies.empty()) {
      composition_.tile(t).release();
      continue;
    }
    if (!composition_.tile(t).allocated()) composition_.allocate(t);
    compose(grid().shape, {grid().spacing.x(), grid().spacing.y()}, bodies, setup_.blur, composition_.tile(t));
  }
  exchange_.fill(composition_, no_solid);
}

void ReferenceMapScene::initialize(const StateFunction<2>& gas) {
  for (const auto& map : maps_)
    if (!map->initialize())
      throw InputError("solid " + map->name() + ": its displacement at t = 0 turns it inside out");
  compose_all();
  const double gamma = fluid_.setup().gas.gamma;
  for (int t = 0; t < composition_.tiles(); ++t) {
    if (!composition_.tile(t).allocated()) continue;
    const TileBlock& part = composition_.tile(t);
    const Index<2> first = grid().first_cell(t);
    for_each_cell<2>(grid().shape, 0, [&](const Index<2>& c) {
      const std::size_t k = grid().shape.at(c);
      const double share = part.component(composition::share)[k];
      if (share == 0) return;
      const Point<2> x = grid().center({first[0] + c[0], first[1] + c[1]});
      const double of_gas = std::max(0.0, 1 - share);
      Primitive<2> W = gas(x, 0);
      Point<2> velocity = of_gas * Point<2>(W.velocity[0], W.velocity[1]);
      for (std::size_t b = 0; b < maps_.size(); ++b) {
        const TileBlock& map = maps_[b]->field().tile(t);
        if (!map.allocated() || !(map.component(2)[k] < setup_.blur) || !setup_.bodies[b].velocity) continue;
        const double of_body = solid_share(map.component(2)[k], 1 / setup_.blur) / std::max(share, 1.0);
        velocity += of_body * setup_.bodies[b].velocity({map.component(0)[k], map.component(1)[k]});
      }
      W.density = of_gas * W.density + part.component(composition::mass)[k];
      W.velocity = {velocity.x(), velocity.y()};
      W.pressure = of_gas * W.pressure + share * setup_.pressure;
      Conserved<2> U = to_conserved(W, gamma);
      U.energy += part.component(composition::energy)[k];
      put<2>(fluid_.fields().front().tile(t), k, U);
    });
  }
}

bool ReferenceMapScene::begin(double dt) {
  const auto scope = timers_("reference map");
  bool good = true;
  for (const auto& map : maps_) good = map->drift_to_half(0.5 * dt, velocities()) && good;
  for (int t = 0; t < composition_.tiles(); ++t)
    if (!composition_.tile(t).allocated() && covers(t)) composition_.allocate(t);
  return good;
}

StepResult ReferenceMapScene::step(const CartesianTile<2>& cells, int tile, double dt, const StepOptions& options) {
  const std::vector<TileBody> bodies = bodies_on(tile, true);
  return mixture_step(mixture(cells, tile, bodies), dt, options);
}

StepResult ReferenceMapScene::rate(const CartesianTile<2>& cells, int tile, const StepOptions& options) {
  CartesianTile<2> present = cells;
  present.next = fluid_.fields().front().tile(tile).component(0);
  return mixture_rate(mixture(present, tile, {}), options, restored_);
}

void ReferenceMapScene::finish(double dt, double time) {
  const auto scope = timers_("reference map");
  for (const auto& map : maps_)
    if (!map->drift_to_end(0.5 * dt, velocities())) throw NumericalError("solid " + map->name() + " turns inside out");
  settle(time);
}

void ReferenceMapScene::resume(double time) {
  for (const auto& map : maps_) map->resume();
  settle(time);
}

/// What solids take of the cells, rates, and pressure for gas squeezed beside them.
void ReferenceMapScene::settle(double time) {
  compose_all();
  double restored = 0;
  for (int t = 0; t < composition_.tiles(); ++t)
    if (composition_.tile(t).allocated())
      fluid_.rates().front()[static_cast<std::size_t>(t)] =
          mixture_rate(mixture(view(t), t, {}), fluid_.setup().options, restored).rate;
  restored_ += restored * grid().spacing.prod();
  if (fluid_.communicator().any(restored > 0)) fluid_.refresh(time);
}

}  // namespace mortise
