// The series of field files of a run: one HDF5 file per output step, fields/step_000123.h5, closed at once, and one
// index, mortise.xdmf, for ParaView and VisIt. Each grid is a "2DSMesh" whose HDF5 datasets have exactly the declared
// rank and extent: nodes (n₁ + 1, n₀ + 1, 2), cell data (n₁, n₀), slowest direction first.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// All members throw EnvironmentError (disk full, unwritable folder). One process writes.
class SeriesWriter {
 public:
  /// Writes into directory/fields and directory/mortise.xdmf. Field files of an earlier run with a time after
  /// `restart_time` are removed, the others stay in the series; without a restart all are removed.
  explicit SeriesWriter(std::string directory, double restart_time = -std::numeric_limits<double>::infinity());

  /// Adds the snapshot to the series (replacing one with the same step). Both files appear whole or not at all.
  /// Cell arrays: the fields, `mask`, and `vtkGhostType` (32, hidden, where the cell is not active).
  void write(const Snapshot& snapshot);

 private:
  struct Entry {
    int step;
    std::string xml;  // the spatial collection of this step
  };
  std::string index() const { return directory_ + "/mortise.xdmf"; }
  void write_index() const;

  std::string directory_;
  std::vector<Entry> entries_;  // by step
};

/// Everything SeriesWriter::write put into the file, to the bit. Throws EnvironmentError.
Snapshot read_snapshot(const std::string& path);

/// Paths of the field files in `directory`/fields, by step; empty when there are none.
std::vector<std::string> series_files(const std::string& directory);

}  // namespace mortise
