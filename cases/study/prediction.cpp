#include "mortise/cases/study/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/scene/scene.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

constexpr int most_cells = 64;       // of a side
constexpr double nearly_rest = 0.1;  // Mach number

FarEnd end_of_gas(const std::string& key) {
  static const Registry<FarEnd> ends(
      "boundary",
      {{"outflow", FarEnd::open}, {"wall", FarEnd::wall}, {"exact", FarEnd::rest}, {"inflow", FarEnd::rest}});
  return ends.at(key);
}

/// A prescribed traction is like a free side to disturbances.
FarEnd end_of_solid(const SideDescription& side) {
  static const Registry<FarEnd> ends(
      "side of a solid",
      {{"free", FarEnd::free}, {"fixed", FarEnd::fixed}, {"slip", FarEnd::fixed}, {"exact", FarEnd::rest}});
  return side.traction.empty() ? ends.at(side.kind) : FarEnd::free;
}

template <int Dim>
double sound_speed(const Primitive<Dim>& W, double gamma) {
  return std::sqrt(gamma * W.pressure / W.density);
}

/// A side of gas in the state W, `length` deep.
template <int Dim>
AcousticSide gas_side(const Primitive<Dim>& W, double gamma, double length, int cells, const std::string& end) {
  AcousticSide side;
  side.speed = sound_speed(W, gamma);
  side.impedance = W.density * side.speed;
  side.spacing = length / cells;
  side.cells = std::min(cells, most_cells);
  side.end = end_of_gas(end);
  return side;
}

// ---- one elastic strip

std::string not_a_strip(const CaseDescription& c) {
  if (!c.bodies.empty() || c.solids.size() != 1) return "more than one body or solid";
  const SolidDescription& solid = c.solids[0];
  if (!solid.strip() || !solid.wet()) return "the solid is no strip beside gas";
  if (!solid.wall.empty()) return "the wall is not straight";
  if (c.initial.kind != "uniform") return "the gas is not uniform at t = 0";
  if (c.coupling.face_ratio != 1) return "the faces of gas and solid differ";
  const double c_gas = std::sqrt(c.gamma * (c.initial.state[3] + c.p_inf) / c.initial.state[0]);
  const double u = c.initial.state[1] - solid.velocity[0], v = c.initial.state[2] - solid.velocity[1];
  return std::hypot(u, v) > nearly_rest * c_gas ? "gas or solid is not at rest at t = 0" : "";
}

AcousticSide solid_side(const CaseDescription& c, const SolidSetup& setup) {
  const Material& material = setup.elastic.options.material;
  AcousticSide side;
  side.speed = material.pressure_wave_speed();
  side.impedance = material.density * side.speed;
  side.spacing = c.solids[0].thickness / setup.elastic.fitted->layers;
  side.cells = std::min(setup.elastic.fitted->layers, most_cells);
  side.end = end_of_solid(c.solids[0].back);
  return side;
}

/// The steps of the gas within one of a solid that waits for it.
std::vector<double> shares(double dt, double of_solid) {
  std::vector<double> all;
  for (double left = of_solid; left > 0; left -= all.back()) all.push_back(step_towards(dt, left));
  return all;
}

GrowthPrediction of_strip(const CaseDescription& c) {
  Scene<2> scene = build_scene<2>(c);
  Simulation<2> simulation(Communicator(), scene.setup);
  simulation.initialize();
  const FittedBody<2>& gas = scene.setup.fluid.bodies[0];
  ElasticLine line;
  line.gas = gas_side(scene.setup.initial(gas.mesh->node(0, 0), 0), c.gamma, c.layer.height, gas.mesh->layers,
                      c.dimension == 1 ? c.right : c.top);
  line.solid = solid_side(c, scene.setup.solids[0]);
  line.scheme = c.scheme;
  line.lagged = c.coupling.wall_velocity == "lagged";
  const Simulation<2>::Pace pace = simulation.pace();
  line.time_step = pace.dt;
  line.solid_substeps = pace.solid_substeps[0];
  if (std::isfinite(pace.solid_step)) {
    line.gas_shares = shares(pace.dt, pace.solid_step);
    line.time_step = pace.solid_step;
    line.solid_substeps = 1;
  }
  GrowthPrediction prediction;
  prediction.factor = growth_factor(line);
  prediction.line = line;
  line.following = 0;
  prediction.along_wall = growth_factor(line);
  prediction.dt = line.time_step / static_cast<double>(std::max<std::size_t>(line.gas_shares.size(), 1));
  prediction.ratio = line.solid.impedance / line.gas.impedance;
  return prediction;
}

// ---- one rigid body

std::string not_a_free_body(const CaseDescription& c) {
  if (c.dimension != 1 || c.bodies.size() != 1 || !c.solids.empty()) return "not one body on a line, nor one strip";
  const BodyDescription& body = c.bodies[0];
  if (body.surface != "wall") return "gas passes through the body";
  if (!body.fixed.empty() || !body.motion_x.empty()) return "the body is not free";
  if (c.initial.kind != "uniform" && c.initial.kind != "riemann") return "the gas is not uniform at t = 0";
  return "";
}

/// The gas that a face of the body at x looks at, `side` (±1) being its normal.
AcousticSide gas_beside(const CaseDescription& c, const SimulationSetup<1>& setup, double x, int side) {
  const double h = setup.fluid.bodies[0].shape.spacing;
  const double length = side > 0 ? setup.fluid.domain.high[0] - x : x - setup.fluid.domain.low[0];
  const Primitive<1> W = setup.initial(Point<1>(x + 0.5 * side * h), 0);
  const int cells = std::max(3, static_cast<int>(std::lround(length / h)));
  return gas_side(W, c.gamma, cells * h, cells, side > 0 ? c.right : c.left);
}

bool at_rest(const CaseDescription& c, const SimulationSetup<1>& setup, double x, int side) {
  const Primitive<1> W = setup.initial(Point<1>(x + 0.5 * side * setup.fluid.bodies[0].shape.spacing), 0);
  return std::abs(W.velocity[0] - c.bodies[0].velocity[0]) <= nearly_rest * sound_speed(W, c.gamma);
}

std::optional<GrowthPrediction> of_body(const CaseDescription& c, std::string& reason) {
  Scene<1> scene = build_scene<1>(c);
  Simulation<1> simulation(Communicator(), scene.setup);
  simulation.initialize();
  const double x = scene.setup.bodies[0].body.pose.position[0];
  const LineAtlas& atlas = *scene.setup.fluid.bodies[0].shape.atlas;
  RigidLine line;
  for (const int side : {1, -1}) {
    const double face = x + (side > 0 ? atlas.right() : atlas.left());
    if (!std::isfinite(face)) continue;
    if (!at_rest(c, scene.setup, face, side)) {
      reason = "gas or body is not at rest at t = 0";
      return std::nullopt;
    }
    line.gases.push_back(gas_beside(c, scene.setup, face, side));
  }
  line.mass = scene.setup.bodies[0].body.mass;
  line.scheme = scene.setup.scheme;
  line.time_step = simulation.pace().dt;
  double z = 0;
  for (const AcousticSide& gas : line.gases) z += gas.impedance;
  GrowthPrediction prediction;
  prediction.factor = prediction.along_wall = growth_factor(line);
  prediction.dt = line.time_step;
  prediction.ratio = line.mass / (z * line.time_step);
  prediction.line = line;
  return prediction;
}

}  // namespace

std::optional<GrowthPrediction> predict_growth(const CaseDescription& description, std::string* reason) {
  std::string why = description.solids.empty() ? not_a_free_body(description) : not_a_strip(description);
  std::optional<GrowthPrediction> prediction;
  if (why.empty()) prediction = description.solids.empty() ? of_body(description, why) : of_strip(description);
  if (prediction) prediction->rate = std::log(prediction->factor) / prediction->dt;
  if (reason) *reason = why;
  return prediction;
}

}  // namespace mortise
