#include "mortise/coupler/elastic_structure.hpp"

#include <algorithm>

namespace mortise {

std::vector<Point<2>> ElasticStructure::interface_nodes() const {
  std::vector<Point<2>> nodes;
  for (int i = 0; i < grid().row(); ++i) nodes.push_back(grid().node(i, 0));
  return nodes;
}

std::vector<StructureTrace> ElasticStructure::traces(double dt) {
  std::vector<StructureTrace> traces;
  for (const ElasticTrace& trace : solver_.interface_traces(dt)) traces.push_back({trace.velocity, trace.traction, trace.admittance});
  return traces;
}

bool ElasticStructure::step(std::span<const Point<2>> traction, std::span<const Point<2>> velocity, double dt) {
  return solver_.step({traction.begin(), traction.end()}, {velocity.begin(), velocity.end()}, dt);
}

void ElasticStructure::remember() {
  kept_rates_ = solver_.rates();
  kept_fields_.assign(solver_.fields().size(), {});
  for (std::size_t g = 0; g < kept_fields_.size(); ++g)
    for (int t = 0; t < solver_.fields()[g].tiles(); ++t) {
      const std::span<const double> all = solver_.fields()[g].tile(t).all();
      kept_fields_[g].insert(kept_fields_[g].end(), all.begin(), all.end());
    }
}

void ElasticStructure::go_back() {
  solver_.rates() = kept_rates_;
  for (std::size_t g = 0; g < kept_fields_.size(); ++g) {
    const double* next = kept_fields_[g].data();
    for (int t = 0; t < solver_.fields()[g].tiles(); ++t)
      for (double& value : solver_.fields()[g].tile(t).all()) value = *next++;
  }
}

}  // namespace mortise
