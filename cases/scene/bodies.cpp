#include "mortise/cases/scene/bodies.hpp"

#include <cmath>

#include "mortise/cases/input/expression.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr int default_layers = 10;

using OutlineMaker = Outline (*)(const ShapeDescription&);

const Registry<OutlineMaker>& outlines() {
  static const Registry<OutlineMaker> registry(
      "shape",
      {{"circle", [](const ShapeDescription& b) { return Outline::circle(b.radius); }},
       {"ellipse", [](const ShapeDescription& b) { return Outline::ellipse(b.semi_axes[0], b.semi_axes[1]); }},
       {"stick", [](const ShapeDescription& b) { return Outline::rounded_rectangle(b.size[0], b.size[1], b.fillet); }},
       {"rectangle", [](const ShapeDescription& b) { return Outline::rounded_rectangle(b.size[0], b.size[1], b.fillet); }},
       {"polygon",
        [](const ShapeDescription& b) {
          std::vector<Point<2>> corners;
          for (const auto& corner : b.corners) corners.emplace_back(corner[0], corner[1]);
          return Outline::rounded_polygon(corners, b.fillet);
        }},
       {"spline", [](const ShapeDescription& b) { return Outline::spline_from_file(b.points); }}});
  return registry;
}

/// Shape, grid and inertia at density 1 (mass: area or width).
struct Built {
  double mass, inertia, length;
};

Built build_shape(const BodyDescription& description, double spacing, int layers, FittedBody<2>& fitted, BodySetup<2>& body) {
  const auto outline = std::make_shared<Outline>(outline_of(description).centered());
  fitted.shape.atlas = std::make_shared<BodyAtlas>(*outline, grow(*outline, {spacing, layers}));
  body.outline = outline;
  return {outline->area(), outline->second_moment(), outline->mean_radius()};
}

Built build_shape(const BodyDescription& description, double spacing, int layers, FittedBody<1>& fitted, BodySetup<1>&) {
  double left = -LineAtlas::infinity, right = LineAtlas::infinity;
  if (description.shape == "slab") {
    left = -0.5 * description.width;
    right = 0.5 * description.width;
  } else {
    (description.side == "left" ? right : left) = 0;
  }
  fitted.shape.atlas = std::make_shared<LineAtlas>(left, right, spacing, layers);
  return {description.width, 0, 1};
}

}  // namespace

Outline outline_of(const ShapeDescription& shape) { return outlines().at(shape.shape)(shape); }

int body_layers(int wished) { return wished > 0 ? wished + wished % 2 : default_layers; }

template <int Dim>
void add_body(const CaseDescription& description, std::size_t index, double spacing, SimulationSetup<Dim>& setup,
              std::vector<PlacedShape<Dim>>& shapes) {
  const BodyDescription& from = description.bodies[index];
  FittedBody<Dim> fitted;
  BodySetup<Dim> body;
  fitted.name = from.name;
  fitted.wall = from.surface == "wall";
  fitted.shape.spacing = spacing;
  fitted.shape.layers = body_layers(from.layers);
  const std::string label = "bodies." + std::to_string(index) + " (" + from.name + ")";
  Built built;
  try {
    built = build_shape(from, spacing, fitted.shape.layers, fitted, body);
  } catch (const InputError& error) {
    throw InputError(from.place + ": " + label + ": " + error.what());
  }
  RigidBody<Dim>& rigid = body.body;
  rigid.name = from.name;
  rigid.mass = from.density ? *from.density * built.mass : from.mass.value_or(0);
  rigid.inertia = from.density ? *from.density * built.inertia : from.inertia.value_or(0);
  rigid.length = built.length;
  const double instant = 1e-6 * description.time_end;
  const std::string* motion[] = {&from.motion_x, &from.motion_y, &from.motion_angle};
  const std::string* force[] = {&from.force_x, &from.force_y, &from.torque};
  static constexpr const char* names[] = {"x", "y", "angle"};
  for (int k = 0; k < degrees_of_freedom<Dim>; ++k) {
    const auto degree = static_cast<std::size_t>(k);
    const int entry = k < Dim ? k : 2;
    if (k < Dim) {
      rigid.pose.position[k] = from.position[degree];
      rigid.y[k] = from.velocity[degree];
    } else {
      rigid.pose.angle = from.angle * radians_per_degree;
      rigid.y[k] = from.angular_velocity;
    }
    body.motion[degree] = function_of_time(*motion[entry], k < Dim ? 1 : radians_per_degree);
    body.force[degree] = function_of_time(*force[entry]);
    rigid.held[degree] = body.motion[degree] || std::find(from.fixed.begin(), from.fixed.end(), names[entry]) != from.fixed.end();
    if (rigid.held[degree]) rigid.y[k] = body.motion[degree] ? (body.motion[degree](instant) - body.motion[degree](0)) / instant : 0.0;
  }
  shapes.push_back({fitted.shape.atlas, body.outline, rigid.pose, from.place, label});
  setup.fluid.bodies.push_back(std::move(fitted));
  setup.bodies.push_back(std::move(body));
}

template void add_body<1>(const CaseDescription&, std::size_t, double, SimulationSetup<1>&, std::vector<PlacedShape<1>>&);
template void add_body<2>(const CaseDescription&, std::size_t, double, SimulationSetup<2>&, std::vector<PlacedShape<2>>&);

}  // namespace mortise
