#include "mortise/cases/exact/elastic_cases.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/exact/annulus_mode.hpp"
#include "mortise/cases/exact/deforming_diffuser.hpp"
#include "mortise/cases/exact/elastic_bar.hpp"
#include "mortise/cases/exact/elastic_piston.hpp"
#include "mortise/cases/exact/elastic_piston_shock.hpp"
#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/cases/exact/plane_waves.hpp"
#include "mortise/cases/exact/radial_reference.hpp"
#include "mortise/cases/exact/rayleigh_wave.hpp"
#include "mortise/cases/exact/superseismic_shock.hpp"
#include "mortise/cases/input/expression.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using Made = std::unique_ptr<ExactSolution<2>>;

LoadLaw load_of(const CaseDescription& c) {
  return c.coupling.load == "current" ? LoadLaw::current_area : LoadLaw::reference_area;
}

/// What problems with gas have in common; `gas` (ρ, u, v, p).
template <class Problem>
Problem with_gas(const CaseDescription& c, const std::array<double, 4>& gas) {
  Problem problem;
  problem.gamma = c.gamma;
  problem.density = gas[0];
  problem.pressure = gas[3];
  problem.material = material_of(c.solids[0]);
  return problem;
}

ElasticPistonProblem beside_a_wall(const CaseDescription& c) {
  auto problem = with_gas<ElasticPistonProblem>(c, c.initial.state);
  problem.p_inf = c.p_inf;
  problem.reference_pressure = c.coupling.reference_pressure;
  problem.length = c.solids[0].thickness;
  problem.angle = c.layer.angle * radians_per_degree;
  problem.time_end = c.time_end;
  return problem;
}

/// The interface moves with F = −t⁴/4 along the wall's normal.
Made elastic_piston(const CaseDescription& c) {
  return std::make_unique<ElasticPiston>(power_of_time(beside_a_wall(c), -0.25, 4));
}

/// The initial velocity of the solid along the wall's normal, from its formulas.
Made elastic_bar(const CaseDescription& c) {
  const SolidDescription& solid = c.solids[0];
  if (solid.initial.kind != "formula" || solid.back.kind != "fixed" ||
      c.coupling.reference_pressure != c.initial.state[3])
    throw InputError(
        "exact = \"elastic_bar\" needs solids.0.initial.kind = \"formula\" with a velocity, solids.0.sides.back = "
        "\"fixed\" "
        "and coupling.reference_pressure equal to the pressure of the gas");
  const auto parsed = [](const std::string& formula) {
    return Expression(formula.empty() ? "0" : formula, {"x", "y"});
  };
  const ElasticPistonProblem problem = beside_a_wall(c);
  const auto velocity = [n = direction(problem.angle), u = parsed(solid.initial.velocity_x),
                         v = parsed(solid.initial.velocity_y)](double xi) {
    return u(xi * n[0], xi * n[1]) * n[0] + v(xi * n[0], xi * n[1]) * n[1];
  };
  return std::make_unique<ElasticPiston>(fixed_bar(problem, velocity));
}

Made elastic_piston_shock(const CaseDescription& c) {
  auto problem = with_gas<ElasticPistonShockProblem>(c, c.initial.right);
  const std::string& back = c.solids[0].back.kind;
  problem.p_inf = c.p_inf;
  problem.mach = c.initial.mach;
  problem.distance = -c.initial.position;  // the shock runs against the wall's normal
  problem.reference_pressure = c.coupling.reference_pressure;
  problem.length = c.solids[0].thickness;
  problem.back = back == "fixed" ? SolidBack::fixed : back == "free" ? SolidBack::free : SolidBack::open;
  problem.angle = c.layer.angle * radians_per_degree;
  return std::make_unique<ElasticPistonShock>(problem);
}

Made superseismic_shock(const CaseDescription& c) {
  auto problem = with_gas<SuperseismicShockProblem>(c, c.initial.state);
  problem.p_inf = c.p_inf;
  problem.reference_pressure = c.coupling.reference_pressure;
  problem.load = load_of(c);
  return std::make_unique<SuperseismicShock>(problem);
}

Made deforming_diffuser(const CaseDescription& c) {
  auto problem = with_gas<DeformingDiffuserProblem>(c, c.initial.state);
  problem.speed = c.initial.state[1];
  problem.reference_pressure = c.coupling.reference_pressure;
  problem.period = c.layer.along_high - c.layer.along_low;
  problem.height = c.solids[0].thickness;
  problem.load = load_of(c);
  const std::string& wall = c.solids[0].wall;
  problem.wall = [formula = Expression(wall.empty() ? "0" : wall, {"x"})](double x) { return formula(x); };
  try {
    return std::make_unique<DeformingDiffuser>(problem);
  } catch (const NumericalError& error) {
    throw InputError(std::string("exact = \"deforming_diffuser\" has no steady flow over this wall: ") + error.what());
  }
}

/// σ_rr on the far side of the solid; empty: held.
std::function<double(double)> far_stress(const SolidDescription& solid, double radius) {
  const SideDescription& side = solid.gas == "inside" ? solid.outer : solid.inner;
  if (side.kind == "fixed") return {};
  if (side.traction.empty()) return [](double) { return 0.0; };
  const auto formula = std::make_shared<Expression>(side.traction, std::vector<std::string>{"t", "x", "y"});
  return [formula, radius](double t) {
    const double values[] = {t, radius, 0.0};
    return (*formula)(values);
  };
}

Made radial_reference(const CaseDescription& c) {
  const SolidDescription& solid = c.solids[0];
  const bool inside = solid.gas == "inside";
  auto problem = with_gas<RadialProblem>(c, c.initial.state);
  problem.p_inf = c.p_inf;
  problem.angular_velocity = solid.angular_velocity;
  problem.load = load_of(c);
  problem.time_end = c.time_end;
  problem.interface_radius = !solid.annulus() ? solid.radius : inside ? solid.inner_radius : solid.outer_radius;
  problem.solid_end = !solid.annulus() ? 0 : inside ? solid.outer_radius : solid.inner_radius;
  if (solid.annulus()) problem.far_stress = far_stress(solid, problem.solid_end);
  if (c.layered())
    problem.gas_end = inside ? c.layer.inner_radius : c.layer.outer_radius;
  else if (!inside)
    problem.gas_end = std::min({-c.domain_low[0], -c.domain_low[1], c.domain_high[0], c.domain_high[1]});
  return std::make_unique<RadialReference>(problem);
}

Made plane_waves(const CaseDescription& c) {
  const SolidInitialDescription& wave = c.solids[0].initial;
  const PlaneWaveKind kind = wave.wave == "shear" ? PlaneWaveKind::shear : PlaneWaveKind::pressure;
  const PlaneWave plane{kind,           WaveProfile::sine, wave.angle * radians_per_degree,
                        wave.amplitude, wave.position,     wave.length};
  return std::make_unique<PlaneWaves>(material_of(c.solids[0]), std::vector<PlaneWave>{plane});
}

Made annulus_modes(const CaseDescription& c) {
  const SolidDescription& b = c.solids[0];
  return std::make_unique<AnnulusMode>(
      AnnulusModeProblem{material_of(b), b.inner_radius, b.outer_radius, b.initial.mode, b.initial.amplitude});
}

/// On the top side of a plate.
Made rayleigh_wave(const CaseDescription& c) {
  const SolidDescription& b = c.solids[0];
  return std::make_unique<RayleighWave>(
      RayleighWaveProblem{material_of(b), b.initial.length, b.initial.amplitude, 0, Point<2>(0, b.high[1])});
}

}  // namespace

Material material_of(const SolidDescription& solid) {
  const MaterialDescription& m = solid.material;
  return {stress_laws().at(m.law), m.density, m.lambda, m.mu};
}

std::vector<std::pair<std::string, ElasticMaker>> elastic_solutions() {
  return {{"elastic_piston", elastic_piston},
          {"elastic_bar", elastic_bar},
          {"elastic_piston_shock", elastic_piston_shock},
          {"superseismic_shock", superseismic_shock},
          {"deforming_diffuser", deforming_diffuser},
          {"radial_reference", radial_reference},
          {"plane_waves", plane_waves},
          {"annulus_modes", annulus_modes},
          {"rayleigh_wave", rayleigh_wave}};
}

}  // namespace mortise
