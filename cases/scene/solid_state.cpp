#include "mortise/cases/scene/solid_state.hpp"

#include <cmath>

#include "mortise/cases/input/expression.hpp"

namespace mortise {
namespace {

ExactSolid with_stress(const Material& material, ExactSolid solid) {
  solid.stress = stress(material, Gradient::Identity() + solid.gradient);
  return solid;
}

/// v = velocity + ω × (X − position), undeformed.
SolidFunction at_rest(const SolidDescription& from) {
  const Point<2> velocity(from.velocity[0], from.velocity[1]), center(from.position[0], from.position[1]);
  return [velocity, center, omega = from.angular_velocity](const Point<2>& X, double) {
    ExactSolid solid;
    solid.velocity = velocity + omega * Point<2>(center.y() - X.y(), X.x() - center.x());
    return solid;
  };
}

/// u = A (s + c_p t − n·X)₊ n: a compression A running along n, its front at n·X = s at t = 0.
SolidFunction plane_wave(const SolidInitialDescription& from, const Material& material) {
  const Point<2> n(std::cos(from.angle * radians_per_degree), std::sin(from.angle * radians_per_degree));
  const double speed = material.pressure_wave_speed(), amplitude = from.amplitude, start = from.position;
  return [=](const Point<2>& X, double t) {
    ExactSolid solid;
    const double behind = start + speed * t - n.dot(X);
    if (behind <= 0) return solid;
    solid.displacement = amplitude * behind * n;
    solid.velocity = amplitude * speed * n;
    solid.gradient = -amplitude * n * n.transpose();
    return with_stress(material, solid);
  };
}

using PlaceFunction = std::function<double(const Point<2>&)>;

PlaceFunction of_place(const std::string& formula) {
  const auto expression =
      std::make_shared<Expression>(formula.empty() ? "0" : formula, std::vector<std::string>{"x", "y"});
  return [expression](const Point<2>& X) { return (*expression)(X.x(), X.y()); };
}

SolidFunction by_formula(const SolidInitialDescription& from, const Material& material) {
  const PlaceFunction u[] = {of_place(from.displacement_x), of_place(from.displacement_y)};
  const PlaceFunction v[] = {of_place(from.velocity_x), of_place(from.velocity_y)};
  return [=](const Point<2>& X, double) {
    constexpr double step = 1e-5;
    ExactSolid solid;
    for (int i = 0; i < 2; ++i) {
      solid.displacement[i] = u[i](X);
      solid.velocity[i] = v[i](X);
      for (int j = 0; j < 2; ++j) {
        const Point<2> dX = step * Point<2>::Unit(j);
        solid.gradient(i, j) = (u[i](X + dX) - u[i](X - dX)) / (2 * step);
      }
    }
    return with_stress(material, solid);
  };
}

const Registry<ElasticBoundary>& side_kinds() {
  static const Registry<ElasticBoundary> kinds("side of a solid", {{"free", ElasticBoundary::traction},
                                                                   {"fixed", ElasticBoundary::displacement},
                                                                   {"slip", ElasticBoundary::slip},
                                                                   {"periodic", ElasticBoundary::periodic},
                                                                   {"exact", ElasticBoundary::exact}});
  return kinds;
}

}  // namespace

SolidFunction solid_function(const SolidDescription& solid, const Material& material,
                             const std::shared_ptr<const ExactSolution<2>>& exact) {
  if (solid.initial.kind == "exact") return [exact](const Point<2>& X, double t) { return exact->solid(X, t); };
  if (solid.initial.kind == "plane_wave") return plane_wave(solid.initial, material);
  return solid.initial.kind == "formula" ? by_formula(solid.initial, material) : at_rest(solid);
}

ElasticState elastic_state(StressLaw law, const ExactSolid& solid) {
  const Point<2>&v = solid.velocity, &u = solid.displacement;
  const Eigen::Matrix2d &s = solid.stress, F = Gradient::Identity() + solid.gradient;
  if (law == StressLaw::linear) return {v.x(), v.y(), s(0, 0), s(0, 1), s(1, 1), u.x(), u.y()};
  return {v.x(), v.y(), F(0, 0), F(0, 1), F(1, 0), F(1, 1), u.x(), u.y()};
}

ElasticSide elastic_side(const SideDescription& side) {
  if (side.traction.empty()) return {side_kinds().at(side.kind), {}};
  const auto formula = std::make_shared<Expression>(side.traction, std::vector<std::string>{"t", "x", "y"});
  return {ElasticBoundary::traction, [formula](const Point<2>& X, const Point<2>& N, double t) -> Point<2> {
            const double values[] = {t, X.x(), X.y()};
            return (*formula)(values)*N;
          }};
}

}  // namespace mortise
