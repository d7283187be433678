// An ElasticSolver as the coupler sees it.
#pragma once

#include "mortise/coupler/interface.hpp"
#include "mortise/solid/elastic_solver.hpp"

namespace mortise {

class ElasticStructure : public Structure {
 public:
  explicit ElasticStructure(ElasticSolver& solver) : solver_(solver) {}

  std::vector<Point<2>> interface_nodes() const override;
  bool periodic() const override { return grid().periodic; }
  Point<2> period() const override { return grid().period; }
  double rate() const override { return solver_.rate(); }
  std::vector<StructureTrace> traces(double dt, double theta) override;
  bool step(std::span<const Point<2>> traction, std::span<const Point<2>> velocity, double dt) override;
  void commit(double time) override { solver_.commit(time); }
  std::string first_bad_cell() const override { return solver_.first_bad_cell(); }
  bool can_return() const override { return true; }
  void remember() override { solver_.remember(); }
  void go_back() override { solver_.go_back(); }

 private:
  const GrownGrid& grid() const { return *solver_.setup().fitted; }

  ElasticSolver& solver_;
};

}  // namespace mortise
