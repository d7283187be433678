#include "mortise/cases/driver/recorder.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "mortise/cases/driver/agreement.hpp"
#include "mortise/cases/driver/gather.hpp"
#include "mortise/cases/pictures/render.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "mortise/grids/output/checkpoint.hpp"

namespace mortise {

std::string write_frame(const Snapshot& snapshot, const CaseDescription& description, const std::string& directory,
                        int number) {
  std::string first;
  make_folder(directory + "/frames");
  for (const std::string& field : description.pictures) {
    RenderOptions options;
    options.field = field;
    options.width = description.picture_width;
    options.title = description.title;
    char name[64];
    std::snprintf(name, sizeof name, "/frames/%s_%04d.png", field.c_str(), number);
    write_png(render(snapshot, options), directory + name);
    if (first.empty()) first = directory + name;
    if (description.dimension == 1) break;  // all fields are in one picture
  }
  return first;
}

void write_checkpoint(const Checkpoint& checkpoint, const std::string& case_text, const std::string& directory) {
  CheckpointWriter writer(directory + "/checkpoint.h5");
  writer.write("motion", checkpoint.motion);
  writer.write("tiles", checkpoint.tiles.keys);
  writer.write("rates", checkpoint.tiles.rates);
  writer.write("values", checkpoint.tiles.values);
  writer.write("totals", checkpoint.totals);
  writer.write("case", std::vector<std::string>{case_text});
  writer.finish();
}

Checkpoint read_any_checkpoint(const std::string& directory) {
  const CheckpointReader reader(directory + "/checkpoint.h5");
  return {{reader.integers("tiles"), reader.doubles("rates"), reader.doubles("values")},
          reader.doubles("motion"),
          reader.doubles("totals")};
}

void refuse_checkpoint(const std::string& directory) {
  throw EnvironmentError("cannot read the restart \"" + directory +
                         "/checkpoint.h5\": it is of another scene, its bodies or grids differ");
}

template <int Dim>
Recorder<Dim>::Recorder(const CaseDescription& description, const Simulation<Dim>& simulation, std::string directory,
                        const Communicator& comm, std::optional<double> resume_time)
    : description_(description),
      directory_(std::move(directory)),
      comm_(comm),
      histories_(description, simulation) {
  write([&] {
    histories_.open(directory_, resume_time);
    if (description_.hdf5 && description_.frames > 0)
      series_.emplace(directory_, resume_time.value_or(-std::numeric_limits<double>::infinity()));
  });
}

template <int Dim>
void Recorder<Dim>::write(const std::function<void()>& files) {
  if (comm_.rank() != 0 || failure_) return;
  try {
    files();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

template <int Dim>
void Recorder<Dim>::settle() const {
  agree(comm_, [this] {
    if (failure_) std::rethrow_exception(failure_);
  });
}

template <int Dim>
void Recorder<Dim>::histories(const Simulation<Dim>& simulation) {
  write(histories_.rows(simulation));
}

template <int Dim>
void Recorder<Dim>::frame(const Simulation<Dim>& simulation, int number) {
  Snapshot snapshot = gather_snapshot(simulation, description_.contours);
  for (GridSnapshot& grid : snapshot.grids) grid.dimension = description_.dimension;
  write([&] {
    if (series_) series_->write(snapshot);
    last_picture_ = write_frame(snapshot, description_, directory_, number);
  });
}

template <int Dim>
void Recorder<Dim>::checkpoint(Simulation<Dim>& simulation, const std::vector<double>& totals) {
  const Checkpoint state{gather_tiles(simulation), simulation.motion_state(), totals};
  write([&] { write_checkpoint(state, description_.text, directory_); });
}

template <int Dim>
Checkpoint read_checkpoint(const std::string& directory, const Simulation<Dim>& simulation) {
  Checkpoint checkpoint = read_any_checkpoint(directory);
  if (checkpoint.motion.size() != simulation.motion_state().size() || !fits(checkpoint.tiles, simulation))
    refuse_checkpoint(directory);
  return checkpoint;
}

template class Recorder<1>;
template class Recorder<2>;
template Checkpoint read_checkpoint<1>(const std::string&, const Simulation<1>&);
template Checkpoint read_checkpoint<2>(const std::string&, const Simulation<2>&);

}  // namespace mortise
