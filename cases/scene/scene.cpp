#include "mortise/cases/scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/exact/initial_state.hpp"
#include "mortise/cases/scene/bodies.hpp"
#include "mortise/cases/scene/mapped_solids.hpp"
#include "mortise/cases/scene/solids.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

const Registry<Limiter>& limiters() {
  static const Registry<Limiter> all(
      "limiter", {{"none", Limiter::none}, {"minmod", Limiter::minmod}, {"mc", Limiter::mc}, {"van_albada", Limiter::van_albada}});
  return all;
}

const Registry<RiemannSolver>& riemann_solvers() {
  static const Registry<RiemannSolver> all(
      "Riemann solver", {{"hllc", RiemannSolver::hllc}, {"exact", RiemannSolver::exact}, {"hlle", RiemannSolver::hlle}});
  return all;
}

/// ε² = K h³ q_ref² for (ρ, u, v, p̃): the references are the largest density, speed u + c and pressure at t = 0.
template <int Dim>
std::array<double, 4> van_albada_floor(const SimulationSetup<Dim>& setup, double k, double h) {
  double density = 0, speed = 0, pressure = 0;
  Index<Dim> low{}, high;
  high.fill(64);
  for_each_index<Dim>(low, high, [&](const Index<Dim>& c) {
    Point<Dim> x;
    for (int d = 0; d < Dim; ++d) {
      const double s = (c[static_cast<std::size_t>(d)] + 0.5) / 64;
      x[d] = setup.fluid.domain.low[d] + s * (setup.fluid.domain.high[d] - setup.fluid.domain.low[d]);
    }
    const Primitive<Dim> W = setup.initial(x, 0);
    double u2 = 0;
    for (const double u : W.velocity) u2 += u * u;
    density = std::max(density, W.density);
    speed = std::max(speed, std::sqrt(u2) + std::sqrt(setup.fluid.gas.gamma * W.pressure / W.density));
    pressure = std::max(pressure, W.pressure);
  });
  const double floor = k * h * h * h;
  return {floor * density * density, floor * speed * speed, floor * speed * speed, floor * pressure * pressure};
}

template <int Dim>
void set_boundaries(const CaseDescription& description, const Scene<Dim>& scene, Boundaries<Dim>& boundaries) {
  const std::string* sides[] = {&description.left, &description.right, &description.bottom, &description.top};
  for (std::size_t side = 0; side < 2 * Dim; ++side) boundaries.kind[side] = boundary_kind(*sides[side]);
  boundaries.inflow.density = description.inflow[0];
  for (std::size_t d = 0; d < Dim; ++d) boundaries.inflow.velocity[d] = description.inflow[1 + d];
  boundaries.inflow.pressure = description.inflow[3] + description.p_inf;
  const auto exact = scene.exact;
  const double p_inf = description.p_inf;
  if (exact && exact->describes_fluid())
    boundaries.exact = [exact, p_inf](const Point<Dim>& x, double t) {
      Primitive<Dim> W = exact->state(x, t);
      W.pressure += p_inf;
      return W;
    };
  else
    boundaries.exact = scene.setup.initial;
}

/// The background; returns its cell size, that of all grids.
template <int Dim>
double set_grid(const CaseDescription& description, EulerSetup<Dim>& fluid) {
  double spacing = description.spacing();
  if (!description.has_gas || description.layered()) return spacing;
  static constexpr int preferred[] = {64, 32};
  for (std::size_t d = 0; d < Dim; ++d) {
    const int k = static_cast<int>(d);
    fluid.domain.low[k] = description.domain_low[d];
    fluid.domain.high[k] = description.domain_high[d];
    const int wanted = static_cast<int>(std::lround((fluid.domain.high[k] - fluid.domain.low[k]) / description.spacing()));
    const int tile = description.tile[d];
    const Tiling tiling = tile > 0 ? Tiling{(wanted + tile - 1) / tile * tile, tile} : choose_tiling(wanted, Dim == 1 ? 128 : preferred[d % 2]);
    fluid.cells[d] = tiling.cells;
    fluid.tile[d] = tiling.tile;
    const double size = (fluid.domain.high[k] - fluid.domain.low[k]) / tiling.cells;
    spacing = d == 0 ? size : std::min(spacing, size);
  }
  return spacing;
}

/// (ρ, u, p̃) at t = 0. Scenes without gas have some gas for the sake of a solver without cells.
template <int Dim>
StateFunction<Dim> initial_gas(const CaseDescription& description, const std::shared_ptr<const ExactSolution<Dim>>& exact) {
  if (!description.has_gas) return [](const Point<Dim>&, double) { return Primitive<Dim>{1, {}, 1}; };
  const double p_inf = description.p_inf;
  const auto shifted = [p_inf](Primitive<Dim> W) {
    W.pressure += p_inf;
    return W;
  };
  if (description.initial.kind == "exact")
    return [exact, shifted](const Point<Dim>& x, double) { return shifted(exact->state(x, 0)); };
  const auto initial = std::make_shared<InitialState<Dim>>(description);
  return [initial, shifted](const Point<Dim>& x, double) { return shifted((*initial)(x)); };
}

/// Gas, background, boundaries and options of the fluid solver; returns the cell size.
template <int Dim>
double set_fluid(const CaseDescription& description, Scene<Dim>& scene) {
  EulerSetup<Dim>& fluid = scene.setup.fluid;
  fluid.gas = {description.gamma, description.p_inf};
  fluid.skip = description.skip;
  const double spacing = set_grid(description, fluid);
  set_boundaries(description, scene, fluid.boundaries);
  fluid.options.gamma = description.gamma;
  fluid.options.limiter = limiters().at(description.limiter);
  fluid.options.riemann = riemann_solvers().at(description.riemann);
  return spacing;
}

}  // namespace

Tiling choose_tiling(int wanted, int preferred) {
  for (int cells = std::max(wanted + wanted % 2, 4);; cells += 2) {
    int best = 0;
    for (int tile = 4; tile <= std::min(cells, 2 * preferred); tile += 2)
      if (cells % tile == 0 && std::abs(std::log(double(tile) / preferred)) <= std::abs(std::log(std::max(best, 1) / double(preferred)))) best = tile;
    if (best >= std::min(preferred / 2, cells)) return {cells, best};
  }
}

int scene_dimension(const CaseDescription& description) { return description.solids.empty() ? description.dimension : 2; }

BoundaryKind boundary_kind(const std::string& key) {
  static const Registry<BoundaryKind> kinds("boundary", {{"periodic", BoundaryKind::periodic},
                                                         {"inflow", BoundaryKind::inflow},
                                                         {"outflow", BoundaryKind::outflow},
                                                         {"wall", BoundaryKind::wall},
                                                         {"exact", BoundaryKind::exact}});
  return kinds.at(key);
}

template <int Dim>
Scene<Dim> build_scene(const CaseDescription& description) {
  Scene<Dim> scene;
  SimulationSetup<Dim>& setup = scene.setup;
  EulerSetup<Dim>& fluid = setup.fluid;
  scene.exact = make_exact<Dim>(description);
  setup.initial = initial_gas<Dim>(description, scene.exact);
  fluid.smooth = scene.exact && scene.exact->smooth();
  const double spacing = set_fluid(description, scene);

  setup.scheme = description.scheme == "traditional" && !description.bodies.empty() ? "traditional" : "rigid";
  for (int d = 0; d < Dim; ++d) setup.gravity[d] = description.gravity[static_cast<std::size_t>(d)];
  setup.cfl = description.cfl;
  setup.time_step = description.time_step;
  setup.contact = description.contact;
  setup.restitution = description.restitution;
  setup.contact_gap = (description.contact_gap > 0 ? description.contact_gap : fluid.overlap.least_gap) * spacing;

  std::vector<PlacedShape<Dim>> shapes;
  for (std::size_t b = 0; b < description.bodies.size(); ++b) add_body<Dim>(description, b, spacing, setup, shapes);
  if constexpr (Dim == 2) {
    const auto add = description.scheme == "reference-map" ? add_mapped_solid : add_solid;
    for (std::size_t k = 0; k < description.solids.size(); ++k) add(description, k, spacing, scene.exact, setup, shapes);
    if (fluid.cells[0] == 0) fluid.domain = bounds_of(setup);
  }
  fluid.options.van_albada_floor = van_albada_floor<Dim>(setup, description.van_albada_k, description.spacing());
  check_clearance(description.grid_factor, fluid, shapes, fluid.overlap.least_gap * spacing);
  return scene;
}

template Scene<1> build_scene<1>(const CaseDescription&);
template Scene<2> build_scene<2>(const CaseDescription&);

}  // namespace mortise
