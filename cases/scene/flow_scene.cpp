#include "mortise/cases/scene/flow_scene.hpp"

#include <Eigen/Geometry>

#include "mortise/cases/exact/elastic_cases.hpp"
#include "mortise/cases/exact/initial_state.hpp"
#include "mortise/cases/input/expression.hpp"
#include "mortise/cases/scene/bodies.hpp"
#include "mortise/cases/scene/mapped_solids.hpp"
#include "mortise/cases/scene/scene.hpp"
#include "mortise/cases/scene/solid_state.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

constexpr int preferred_tile = 64;

SideKind side_kind(const std::string& key) {
  static const Registry<SideKind> kinds("boundary", {{"periodic", SideKind::periodic},
                                                     {"wall", SideKind::wall},
                                                     {"slip_wall", SideKind::slip_wall},
                                                     {"inflow", SideKind::inflow},
                                                     {"outflow", SideKind::outflow}});
  return kinds.at(key);
}

Anchor anchor_of(const AnchorDescription& from) {
  Anchor anchor;
  anchor.center = {from.center[0], from.center[1]};
  anchor.radius = from.radius;
  anchor.angle = function_of_time(from.angle);
  const auto x = function_of_time(from.x), y = function_of_time(from.y);
  if (x || y) anchor.shift = [x, y](double t) { return Point<2>(x ? x(t) : 0.0, y ? y(t) : 0.0); };
  return anchor;
}

/// A solid that has a velocity of its own at t = 0; without one it moves as the fluid would in its place.
struct MovingSolid {
  std::shared_ptr<const LevelSet> level_set;
  std::function<Point<2>(const Point<2>& x)> reference;  // empty: undeformed
  SolidFunction state;
};

bool has_velocity(const SolidDescription& solid) {
  if (solid.initial.kind == "formula") return !solid.initial.velocity_x.empty() || !solid.initial.velocity_y.empty();
  return solid.velocity != std::array<double, 2>{} || solid.angular_velocity != 0;
}

/// Throws InputError for solids that reach beyond the domain at t = 0.
void check_inside(const SolidDescription& from, const Outline& outline, const SolidFunction& initial,
                  const Box<2>& domain) {
  Box<2> box;
  for (const Point<2>& X : outline.polygon()) box.include(X + initial(X, 0).displacement);
  const Point<2> below = domain.low - box.low, above = box.high - domain.high;
  const double slack = 1e-9 * (domain.high - domain.low).maxCoeff();
  for (const auto& [side, beyond] :
       {std::pair{"left", below.x()}, {"right", above.x()}, {"bottom", below.y()}, {"top", above.y()}})
    if (beyond > slack)
      throw InputError(from.place + ": " + from.name + " reaches " + std::to_string(beyond) + " beyond the " + side +
                       " side of the domain: move it inside");
}

FlowBody body_of(const CaseDescription& description, const SolidDescription& from, double spacing,
                 const Box<2>& domain) {
  refuse_what_cannot_be_mapped(description, from);
  FlowBody body;
  body.name = from.name;
  body.density = from.material.density;
  body.shear_modulus = from.material.mu;
  body.viscosity = from.viscosity;
  const Pose<2> pose = pose_of(from);
  body.level_set = level_set_of(description, from, spacing);
  const SolidFunction initial = solid_function(from, material_of(from), nullptr);
  check_inside(from, outline_of(from).centered().placed(pose), initial, domain);
  if (from.initial.kind == "formula")
    body.reference = [initial](const Point<2>& x) { return reference_point(initial, x); };
  if (!from.actuation.empty()) {
    const auto stretch = std::make_shared<Expression>(from.actuation, std::vector<std::string>{"x", "y", "t"});
    const Eigen::Rotation2Dd back(-pose.angle);
    body.actuation = [stretch, back, center = pose.position](const Point<2>& X, double t) {
      const Point<2> place = back * (X - center);
      return (*stretch)(place.x(), place.y(), t);
    };
    body.axis = pose.angle;
  }
  for (const AnchorDescription& anchor : from.anchors) body.anchors.push_back(anchor_of(anchor));
  return body;
}

}  // namespace

FlowScene build_flow_scene(const CaseDescription& description) {
  FlowScene scene;
  IncompressibleSetup& flow = scene.flow;
  for (std::size_t d = 0; d < 2; ++d) {
    const int k = static_cast<int>(d);
    flow.domain.low[k] = description.domain_low[d];
    flow.domain.high[k] = description.domain_high[d];
    flow.gravity[k] = description.gravity[d];
    const int wanted =
        static_cast<int>(std::lround((flow.domain.high[k] - flow.domain.low[k]) / description.spacing()));
    const int tile = description.tile[d];
    const Tiling tiling =
        tile > 0 ? Tiling{(wanted + tile - 1) / tile * tile, tile} : choose_tiling(wanted, preferred_tile);
    flow.cells[d] = tiling.cells;
    flow.tile[d] = tiling.tile;
  }
  const double spacing =
      (flow.domain.high - flow.domain.low).cwiseQuotient(Point<2>(flow.cells[0], flow.cells[1])).minCoeff();
  const std::string* sides[] = {&description.left, &description.right, &description.bottom, &description.top};
  const Point<2> stream(description.inflow[1], description.inflow[2]);
  for (std::size_t s = 0; s < 4; ++s) {
    flow.sides[s].kind = side_kind(*sides[s]);
    if (flow.sides[s].kind == SideKind::inflow) flow.sides[s].velocity = [stream](const Point<2>&) { return stream; };
    scene.solids.walls[s] = flow.sides[s].kind == SideKind::wall || flow.sides[s].kind == SideKind::slip_wall;
  }
  flow.density = description.fluid_density;
  flow.viscosity = description.fluid_viscosity;
  flow.cfl = 0.5 * description.cfl;  // two directions
  flow.pressure_solver = description.pressure_solver;
  flow.tolerance = 1e-6;
  const auto initial = std::make_shared<InitialState<2>>(description);
  const std::vector<SolidDescription>& solids = description.solids;
  std::vector<MovingSolid> moving;
  for (const SolidDescription& solid : solids) {
    scene.solids.bodies.push_back(body_of(description, solid, spacing, flow.domain));
    const FlowBody& body = scene.solids.bodies.back();
    if (has_velocity(solid))
      moving.push_back({body.level_set, body.reference, solid_function(solid, material_of(solid), nullptr)});
  }
  flow.velocity = [initial, moving](const Point<2>& x) -> Point<2> {
    for (const MovingSolid& solid : moving) {
      const Point<2> X = solid.reference ? solid.reference(x) : x;
      if ((*solid.level_set)(X.x(), X.y()) < 0) return solid.state(X, 0).velocity;
    }
    const Primitive<2> W = (*initial)(x);
    return {W.velocity[0], W.velocity[1]};
  };
  scene.solids.blur = description.coupling.blur;
  scene.solids.fluid_density = description.fluid_density;
  scene.solids.fluid_viscosity = description.fluid_viscosity;
  check(flow);
  return scene;
}

}  // namespace mortise
