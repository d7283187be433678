#include "mortise/coupler/elastic_structure.hpp"

namespace mortise {

std::vector<Point<2>> ElasticStructure::interface_nodes() const {
  std::vector<Point<2>> nodes;
  for (int i = 0; i < grid().row(); ++i) nodes.push_back(grid().node(i, 0));
  return nodes;
}

std::vector<StructureTrace> ElasticStructure::traces(double dt, double theta) {
  std::vector<StructureTrace> traces;
  const auto line = [theta](const Point<2>& now, const Point<2>& half) { return Point<2>(now + 2 * theta * (half - now)); };
  for (const ElasticTrace& t : solver_.interface_traces(dt))
    traces.push_back(theta == 0.5 ? StructureTrace{t.velocity, t.traction, t.admittance, t.tangent}
                                  : StructureTrace{line(t.velocity_now, t.velocity), line(t.traction_now, t.traction), t.admittance,
                                                   line(t.tangent_now, t.tangent)});
  return traces;
}

bool ElasticStructure::step(std::span<const Point<2>> traction, std::span<const Point<2>> velocity, double dt) {
  return solver_.step({traction.begin(), traction.end()}, {velocity.begin(), velocity.end()}, dt);
}

}  // namespace mortise
