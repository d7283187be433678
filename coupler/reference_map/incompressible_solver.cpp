#include "mortise/coupler/reference_map/incompressible_solver.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/coupler/reference_map/edge_prediction.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

PressureProblem problem_of(const FlowGrid& flow, PressurePlace place, double tolerance) {
  PressureProblem problem{&flow.grid(), place, {}, tolerance};
  for (std::size_t s = 0; s < 4; ++s) {
    const SideKind kind = flow.kind(s);
    problem.ends[s] = kind == SideKind::periodic  ? PressureEnd::periodic
                      : kind == SideKind::outflow ? PressureEnd::dirichlet
                                                  : PressureEnd::neumann;
  }
  return problem;
}

void set_all(Field<2>& field, double value) {
  for (int t = 0; t < field.tiles(); ++t) std::ranges::fill(field.tile(t).all(), value);
}

}  // namespace

IncompressibleSolver::IncompressibleSolver(const IncompressibleSetup& setup, const Communicator& comm, Solids* solids)
    : setup_(setup),
      flow_(setup, comm),
      solids_(solids),
      velocity_(flow_.shape(), 2, flow_.tiles()),
      slopes_(flow_.shape(), 4, flow_.tiles()),
      acceleration_(flow_.shape(), 2, flow_.tiles()),
      advection_(flow_.shape(), 2, flow_.tiles()),
      middle_(flow_.shape(), 2, flow_.tiles()),
      star_(flow_.shape(), 2, flow_.tiles()),
      pressure_(flow_.shape(), 1, flow_.tiles()),
      nodal_right_(flow_.shape(), 1, flow_.tiles()),
      correction_(flow_.shape(), 1, flow_.tiles()),
      edge_right_(flow_.shape(), 1, flow_.tiles()),
      edges_{Field<2>(flow_.shape(), 2, flow_.tiles()), Field<2>(flow_.shape(), 2, flow_.tiles())},
      edge_solver_(
          make_pressure_solver(setup.pressure_solver, problem_of(flow_, PressurePlace::cells, setup.tolerance))),
      node_solver_(
          make_pressure_solver(setup.pressure_solver, problem_of(flow_, PressurePlace::nodes, setup.tolerance))) {
  largest_viscosity_ = setup.viscosity / setup.density;
  for (int t = 0; t < flow_.tiles(); ++t)
    for (std::size_t s = 0; s < 4; ++s)
      for (std::size_t c = 0; c < 2; ++c)
        for (int k = 0; flow_.at_side(t, s) && k < walk_of(flow_.shape(), s).count; ++k) {
          double& largest = given_[static_cast<Eigen::Index>(c)];
          largest = std::max(largest, std::abs(flow_.given(t, s, c)[k]));
        }
  for (int d = 0; d < 2; ++d) given_[d] = comm.max(given_[d]);
  if (!solids) return;
  const auto field = [&](int components) { return Field<2>(flow_.shape(), components, flow_.tiles()); };
  fields_ = std::make_unique<SolidFields>(SolidFields{field(1), field(2), field(2), field(2), field(2), field(1)});
  stress_x_ = std::make_unique<Field<2>>(field(2));
  stress_y_ = std::make_unique<Field<2>>(field(2));
  set_all(fields_->density, setup.density);
  set_all(fields_->viscosity, setup.viscosity);
}

ForceTile IncompressibleSolver::force_tile(int tile, const Field<2>& velocity) const {
  ForceTile forces{&flow_.shape(),
                   flow_.spacing(),
                   setup_.gravity,
                   1 / setup_.density,
                   setup_.viscosity,
                   velocity.tile(tile).component(0),
                   pressure_.tile(tile).component(0)};
  if (fields_) {
    forces.density = fields_->density.tile(tile).component(0);
    forces.stress_x = stress_x_->tile(tile).component(0);
    forces.stress_y = stress_y_->tile(tile).component(0);
    forces.body_force = fields_->force.tile(tile).component(0);
  }
  return forces;
}

ProjectionTile IncompressibleSolver::projection_tile(int tile) const {
  return {&flow_.shape(), flow_.spacing(), fields_ ? fields_->density.tile(tile).component(0) : nullptr,
          fields_ ? fields_->divergence.tile(tile).component(0) : nullptr, setup_.density};
}

/// With solids: the whole stress of the given velocity, whose ghosts are filled.
void IncompressibleSolver::prepare_stress(const Field<2>& velocity) {
  if (!fields_) return;
  for (int t = 0; t < flow_.tiles(); ++t)
    fill_stress(flow_.shape(), flow_.spacing(), velocity.tile(t).component(0), fields_->viscosity.tile(t).component(0),
                fields_->stress_x.tile(t).component(0), fields_->stress_y.tile(t).component(0),
                stress_x_->tile(t).component(0), stress_y_->tile(t).component(0));
}

/// 1. Edge velocities at t + dt/2.
void IncompressibleSolver::predict(double dt) {
  const auto phase = timers_("predict");
  for (int t = 0; t < flow_.tiles(); ++t)
    fill_slopes(flow_.shape(), setup_.slopes, velocity_.tile(t).component(0), slopes_.tile(t).component(0));
  flow_.exchange(slopes_);
  prepare_stress(velocity_);
  for (int t = 0; t < flow_.tiles(); ++t) {
    fill_acceleration(force_tile(t, velocity_), acceleration_.tile(t).component(0));
    EdgeTile tile{&flow_.shape(),
                  velocity_.tile(t).component(0),
                  slopes_.tile(t).component(0),
                  acceleration_.tile(t).component(0),
                  edges_.x.tile(t).component(0),
                  edges_.y.tile(t).component(0)};
    for (std::size_t s = 0; s < 4; ++s)
      tile.sides[s] = {flow_.at_side(t, s), flow_.kind(s), {flow_.given(t, s, 0), flow_.given(t, s, 1)}};
    predict_edges(tile, dt, {dt / flow_.spacing()[0], dt / flow_.spacing()[1]});
  }
}

/// 2. MAC projection.
void IncompressibleSolver::project_edges() {
  const auto phase = timers_("project edges");
  for (int t = 0; t < flow_.tiles(); ++t)
    fill_edge_divergence(projection_tile(t), edges_.x.tile(t).component(0), edges_.y.tile(t).component(0),
                         edge_right_.tile(t).component(0));
  counts_.edge_iterations += edge_solver_->solve(edge_right_, density(), correction_, energy_);
  flow_.fill_pressure_beyond(correction_);
  for (int t = 0; t < flow_.tiles(); ++t)
    correct_edges(projection_tile(t), correction_.tile(t).component(0), edges_.x.tile(t).component(0),
                  edges_.y.tile(t).component(0));
}

/// 3. Solids to t + dt, their fields to t + dt/2.
void IncompressibleSolver::carry_solids(double dt) {
  if (!solids_) return;
  const auto phase = timers_("solids");
  solids_->half_step(edges_, time_, dt, *fields_);
  complete_fields();
}

/// Ghosts of the solids' fields, and the largest kinematic viscosity.
void IncompressibleSolver::complete_fields() {
  flow_.fill_even(fields_->density);
  flow_.exchange(fields_->force);
  flow_.exchange(fields_->divergence);
  for (Field<2>* field : {&fields_->viscosity, &fields_->stress_x, &fields_->stress_y}) flow_.exchange_points(*field);
  double viscosity = 0, density = std::numeric_limits<double>::infinity();
  const TileShape<2>& shape = flow_.shape();
  for (int t = 0; t < flow_.tiles(); ++t)
    for (int j = 0; j < shape.cells[1]; ++j) {
      const double *const rho = fields_->density.tile(t).component(0) + shape.at(0, j),
                          *const mu = fields_->viscosity.tile(t).component(0) + shape.at(0, j);
      for (int i = 0; i < shape.cells[0]; ++i) {
        density = std::min(density, rho[i]);
        viscosity = std::max(viscosity, std::max(mu[i], mu[static_cast<std::size_t>(i) + shape.plane]) / rho[i]);
      }
    }
  const Communicator& comm = grid().forest.communicator();
  density = comm.min(density);
  if (!(density > 0)) throw NumericalError("the density of the blend of fluid and solids is not positive everywhere");
  largest_viscosity_ = comm.max(viscosity);
}

/// 4. v* = velocity + dt × accelerations at the middle of the step.
void IncompressibleSolver::advance_star(double dt) {
  const auto phase = timers_("advance");
  for (int t = 0; t < flow_.tiles(); ++t)
    fill_advection(flow_.shape(), flow_.spacing(), edges_.x.tile(t).component(0), edges_.y.tile(t).component(0),
                   advection_.tile(t).component(0));
  const bool viscous = largest_viscosity_ > 0 && dt > 0;
  if (viscous) {
    for (int t = 0; t < flow_.tiles(); ++t)
      add_rates(flow_.shape(), velocity_.tile(t).component(0), 0.5 * dt, acceleration_.tile(t).component(0),
                advection_.tile(t).component(0), middle_.tile(t).component(0));
    flow_.fill_velocity(middle_);
  }
  const Field<2>& stressed = viscous ? middle_ : velocity_;
  prepare_stress(stressed);
  for (int t = 0; t < flow_.tiles(); ++t)
    advance_momentum(force_tile(t, stressed), velocity_.tile(t).component(0), dt, advection_.tile(t).component(0),
                     star_.tile(t).component(0));
}

/// Pressure that takes dt × its gradient from v*. inflow: v* is a velocity, not an acceleration.
void IncompressibleSolver::find_pressure(double dt, bool inflow) {
  const auto phase = timers_("project nodes");
  flow_.fill_flux(star_, inflow);
  for (int t = 0; t < flow_.tiles(); ++t)
    fill_nodal_divergence(projection_tile(t), dt, star_.tile(t).component(0), nodal_right_.tile(t).component(0));
  counts_.node_iterations += node_solver_->solve(nodal_right_, density(), pressure_, inflow ? energy_ / (dt * dt) : 0);
}

/// 5. Nodal projection of v*.
void IncompressibleSolver::project_velocity(double dt) {
  find_pressure(dt, true);
  const auto phase = timers_("project nodes");
  for (int t = 0; t < flow_.tiles(); ++t)
    correct_velocity(projection_tile(t), dt, star_.tile(t).component(0), pressure_.tile(t).component(0),
                     velocity_.tile(t).component(0));
  measure_flow();
  flow_.fill_velocity(velocity_);
}

void IncompressibleSolver::initialize() {
  const TileShape<2>& shape = flow_.shape();
  for (int t = 0; t < flow_.tiles(); ++t)
    for_each_cell<2>(shape, 0, [&](const Index<2>& c) {
      const Index<2> first = grid().first_cell(t);
      const Point<2> v =
          setup_.velocity ? setup_.velocity(grid().center({first[0] + c[0], first[1] + c[1]})) : Point<2>(0, 0);
      for (int k = 0; k < 2; ++k) star_.tile(t).component(k)[shape.at(c)] = v[k];
    });
  if (solids_) {
    solids_->begin(*fields_);
    complete_fields();
  }
  project_velocity(1);
  set_all(pressure_, 0);
  predict(0);
  project_edges();
  carry_solids(0);
  advance_star(0);
  // With Δt = 0 the accelerations come from a step of length 1 off zero.
  set_all(middle_, 0);
  for (int t = 0; t < flow_.tiles(); ++t)
    advance_momentum(force_tile(t, velocity_), middle_.tile(t).component(0), 1, advection_.tile(t).component(0),
                     star_.tile(t).component(0));
  find_pressure(1, false);
  counts_ = {};
}

double IncompressibleSolver::rate() const {
  const Point<2>& h = flow_.spacing();
  double fastest = solids_ ? solids_->rate() : 0;
  // ∇·μ(∇v + ∇vᵀ), which blends need, damps what is not free of divergence twice as fast as μ∇²v.
  double slow =
      (solids_ ? 4 : 2) * largest_viscosity_ * (1 / (h[0] * h[0]) + 1 / (h[1] * h[1])) / setup_.viscous_fraction;
  for (int d = 0; d < 2; ++d) {
    fastest = std::max(fastest, std::max(largest_[d], given_[d]) / h[d]);
    slow = std::max(slow, std::sqrt(std::abs(setup_.gravity[d]) / (2 * setup_.cfl * h[d])));
  }
  return std::max(fastest / setup_.cfl, slow);
}

double IncompressibleSolver::advance(double limit) {
  const double fastest = rate();
  const double dt = fastest * limit > 1 ? 1 / fastest : limit;
  predict(dt);
  project_edges();
  carry_solids(dt);
  advance_star(dt);
  project_velocity(dt);
  time_ += dt;
  ++counts_.steps;
  if (!largest_.allFinite()) throw NumericalError("velocities are not finite at t = " + std::to_string(time_));
  if (solids_) {
    const auto phase = timers_("solids");
    solids_->full_step(velocity_, time_, *fields_);
    complete_fields();
  }
  return dt;
}

}  // namespace mortise
