#include "mortise/coupler/schemes.hpp"

#include "mortise/coupler/schemes/common.hpp"

namespace mortise {

namespace {

template <class Value>
void put_first(std::vector<Value>& list, const Value& value) {
  list.insert(list.begin(), value);
  if (list.size() > 2) list.pop_back();
}

}  // namespace

void InterfaceHistory::remember(const InterfaceSolution& solution) {
  put_first(wall_velocity, solution.velocity);
  put_first(pressure, solution.load);
}

const Registry<InterfaceScheme>& interface_schemes() {
  static const Registry<InterfaceScheme> registry("coupling scheme",
                                                  {{"projection", &schemes::projection},
                                                   {"traditional", &schemes::traditional},
                                                   {"traditional-subiterated", &schemes::traditional_subiterated},
                                                   {"anti-traditional", &schemes::anti_traditional}});
  return registry;
}

std::vector<Point<2>> tractions(const InterfaceProblem& problem, std::span<const double> pressure,
                                const InterfaceOptions& options) {
  std::vector<Point<2>> traction(problem.structure.size(), Point<2>::Zero());
  for (const Transfer::Piece& piece : problem.transfer->pieces()) {
    const auto s = static_cast<std::size_t>(piece.structure), b = static_cast<std::size_t>(piece.fluid);
    const double net = pressure[b] - options.reference_pressure;
    if (options.reference_load)
      traction[s] -= net * piece.of_structure * schemes::unit(problem.area[b]);
    else
      traction[s] -= net * piece.of_fluid / problem.reference_length[s] * problem.area[b];
  }
  return traction;
}

}  // namespace mortise
