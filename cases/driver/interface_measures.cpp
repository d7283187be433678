#include "mortise/cases/driver/interface_measures.hpp"

#include <cmath>
#include <limits>

namespace mortise {
namespace {

bool closed(const InterfaceState& interface) { return interface.periodic && interface.period.isZero(); }

/// Calls visit(first node, its position, second node, its position) for every edge.
template <class Visit>
void for_each_edge(const std::vector<Point<2>>& nodes, bool periodic, const Point<2>& period, Visit&& visit) {
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) visit(k, nodes[k], k + 1, nodes[k + 1]);
  if (periodic && !nodes.empty()) visit(nodes.size() - 1, nodes.back(), std::size_t{0}, Point<2>(nodes[0] + period));
}

Point<2> mean_velocity(const InterfaceState& interface) {
  double length = 0;
  Point<2> sum = Point<2>::Zero();
  for_each_edge(interface.nodes, interface.periodic, interface.period,
                [&](std::size_t i, const Point<2>& a, std::size_t k, const Point<2>& b) {
                  const double edge = (b - a).norm();
                  length += edge;
                  sum += 0.5 * edge * (interface.node_velocities[i] + interface.node_velocities[k]);
                });
  return sum / length;
}

/// Over the fluid's faces, which run the other way than the structure's.
double mean_pressure(const InterfaceState& interface) {
  if (interface.pressure.empty()) return std::numeric_limits<double>::quiet_NaN();
  double length = 0, sum = 0;
  for_each_edge(interface.fluid_nodes, interface.periodic, -interface.period,
                [&](std::size_t face, const Point<2>& a, std::size_t, const Point<2>& b) {
                  length += (b - a).norm();
                  sum += (b - a).norm() * interface.pressure[face];
                });
  return sum / length;
}

}  // namespace

double area_below(const InterfaceState& interface) {
  const Point<2> along = interface.period.isZero() ? Point<2>(1, 0) : Point<2>(interface.period.normalized());
  const Point<2> across(-along.y(), along.x());
  double area = 0;
  for_each_edge(interface.nodes, interface.periodic, interface.period,
                [&](std::size_t, const Point<2>& a, std::size_t, const Point<2>& b) {
                  area -= 0.5 * across.dot(a + b) * along.dot(b - a);
                });
  return area;
}

InterfaceMeasures measure(const InterfaceState& interface, double p_inf) {
  InterfaceMeasures measures;
  for (const Point<2>& node : interface.nodes) measures.box.include(node);
  measures.area = closed(interface) ? std::fabs(area_below(interface)) : 0;
  measures.pressure = mean_pressure(interface) - p_inf;
  measures.velocity = mean_velocity(interface);
  measures.force = interface.force;
  return measures;
}

}  // namespace mortise
