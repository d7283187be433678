// Histories of a run as CSV files: bodies.csv, probes.csv, solid_probes.csv, interface.csv; only those that have rows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mortise/cases/input/case_description.hpp"
#include "mortise/coupler/simulation.hpp"
#include "mortise/grids/output/csv.hpp"

namespace mortise {

/// Probes inside a solid follow the material point whose reference position was asked for; all others stay in space.
template <int Dim>
class Histories {
 public:
  /// Which probe is in which solid is found here. Collective; writes nothing.
  Histories(const CaseDescription& description, const Simulation<Dim>& simulation);

  /// Starts the files, or goes on with those of an earlier run up to `resume_time`. On rank 0.
  void open(const std::string& directory, std::optional<double> resume_time);

  /// A row per body, probe and interface of the present instant: gathers, and returns what writes them on rank 0.
  /// Collective.
  std::function<void()> rows(const Simulation<Dim>& simulation);

 private:
  using Row = std::vector<CsvValue>;
  void add_bodies(const Simulation<Dim>& simulation, std::vector<Row>& rows) const;
  void add_probes(const Simulation<Dim>& simulation, std::vector<Row>& rows) const;
  void add_solid_probes(const Simulation<Dim>& simulation, std::size_t solid, std::vector<Row>& rows) const;
  void add_interfaces(const Simulation<Dim>& simulation, std::vector<Row>& rows) const;

  struct Probes {
    std::vector<std::string> names;
    std::vector<Point<Dim>> points;
  };
  Probes fluid_probes_;
  std::vector<Probes> solid_probes_;  // per solid
  bool has_bodies_, has_interfaces_;
  std::optional<CsvWriter> bodies_, probes_, solids_, interfaces_;
};

}  // namespace mortise
