#include "mortise/cases/driver/recorder.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "mortise/cases/driver/agreement.hpp"
#include "mortise/cases/pictures/render.hpp"
#include "mortise/fluid/cell.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "mortise/grids/output/checkpoint.hpp"

namespace mortise {
namespace {

const std::vector<std::string> body_columns = {"t", "body", "x", "y", "angle", "vx", "vy", "omega", "fx", "fy", "torque"};
const std::vector<std::string> probe_columns = {"t", "probe", "density", "velocity_x", "velocity_y", "pressure"};

CsvWriter open_history(const std::string& path, const std::vector<std::string>& columns, std::optional<double> resume_time) {
  return resume_time ? CsvWriter::truncate_after(path, columns, *resume_time) : CsvWriter(path, columns);
}

}  // namespace

template <int Dim>
Recorder<Dim>::Recorder(const CaseDescription& description, std::string directory, const Communicator& comm, std::optional<double> resume_time)
    : description_(description), directory_(std::move(directory)), comm_(comm) {
  write([&] {
    if (!description_.bodies.empty()) bodies_.emplace(open_history(directory_ + "/bodies.csv", body_columns, resume_time));
    if (!description_.probes.empty()) probes_.emplace(open_history(directory_ + "/probes.csv", probe_columns, resume_time));
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
  const double t = simulation.time();
  write([&] {
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
      const RigidBody<Dim>& body = simulation.bodies()[b];
      const BodyLoad<Dim>& load = simulation.loads()[b];
      const bool plane = Dim == 2;
      bodies_->row({t, body.name, body.pose.position[0], plane ? body.pose.position[Dim - 1] : 0.0, body.pose.angle, body.y[0],
                    plane ? body.y[Dim - 1] : 0.0, plane ? body.y[degrees_of_freedom<Dim> - 1] : 0.0, load.force[0],
                    plane ? load.force[Dim - 1] : 0.0, load.torque});
    }
  });
  if (description_.probes.empty()) return;
  std::vector<Point<Dim>> points;
  for (const ProbeDescription& probe : description_.probes) {
    Point<Dim> x;
    for (int d = 0; d < Dim; ++d) x[d] = probe.position[static_cast<std::size_t>(d)];
    points.push_back(x);
  }
  const Gas gas = simulation.fluid().setup().gas;
  constexpr int components = euler_components<Dim>;
  const auto values = simulation.fluid().overlap().template sample<components>(
      simulation.fluid().fields(), points, [&gas](const double* U, double* W) { decode<Dim>(U, W, gas.gamma); });
  write([&] {
    for (std::size_t p = 0; p < points.size(); ++p)
      probes_->row({t, description_.probes[p].name, values[p][0], values[p][1], Dim == 2 ? values[p][Dim] : 0.0, values[p][Dim + 1] - gas.p_inf});
  });
}

template <int Dim>
void Recorder<Dim>::frame(const Simulation<Dim>& simulation, int number) {
  const Snapshot snapshot = gather_snapshot(simulation);
  write([&] {
    if (series_) series_->write(snapshot);
    write_pictures(snapshot, number);
  });
}

template <int Dim>
void Recorder<Dim>::write_pictures(const Snapshot& snapshot, int number) {
  make_folder(directory_ + "/frames");
  for (const std::string& field : description_.pictures) {
    RenderOptions options;
    options.field = field;
    options.width = description_.picture_width;
    options.title = description_.title;
    char name[64];
    std::snprintf(name, sizeof name, "/frames/%s_%04d.png", field.c_str(), number);
    write_png(render(snapshot, options), directory_ + name);
    if (field == description_.pictures.front()) last_picture_ = directory_ + name;
    if (Dim == 1) break;  // all fields are in one picture
  }
}

template <int Dim>
void Recorder<Dim>::checkpoint(Simulation<Dim>& simulation, int next_frame, const std::vector<double>& totals) {
  const TileRecords tiles = gather_tiles(simulation);
  write([&] {
    CheckpointWriter writer(directory_ + "/checkpoint.h5");
    writer.write("motion", simulation.motion_state());
    writer.write("tiles", tiles.keys);
    writer.write("rates", tiles.rates);
    writer.write("values", tiles.values);
    writer.write("totals", totals);
    writer.write("next_frame", std::vector<std::int64_t>{next_frame});
    writer.write("case", std::vector<std::string>{description_.text});
    writer.finish();
  });
}

namespace {

/// The records are those of the simulation's tiles, one by one.
template <int Dim>
bool fits(const TileRecords& tiles, const Simulation<Dim>& simulation) {
  std::size_t tile = 0, values = 0;
  if (tiles.keys.size() != 3 * tiles.rates.size()) return false;
  const auto& grids = simulation.fluid().grids();
  for (std::size_t g = 0; g < grids.size(); ++g)
    for (std::int64_t t = 0; t < grids[g].forest.global_count(); ++t, ++tile) {
      if (tile == tiles.rates.size() || tiles.keys[3 * tile] != static_cast<std::int64_t>(g) || tiles.keys[3 * tile + 1] != t) return false;
      if (tiles.keys[3 * tile + 2] != 0) values += static_cast<std::size_t>(grids[g].shape.count() * euler_components<Dim>);
    }
  return tile == tiles.rates.size() && values == tiles.values.size();
}

}  // namespace

template <int Dim>
Checkpoint read_checkpoint(const std::string& directory, const Simulation<Dim>& simulation) {
  const CheckpointReader reader(directory + "/checkpoint.h5");
  Checkpoint checkpoint{{reader.integers("tiles"), reader.doubles("rates"), reader.doubles("values")},
                        reader.doubles("motion"),
                        reader.doubles("totals"),
                        static_cast<int>(reader.integers("next_frame").at(0))};
  if (checkpoint.motion.size() != simulation.motion_state().size() || !fits(checkpoint.tiles, simulation))
    throw EnvironmentError("cannot read the restart \"" + directory + "/checkpoint.h5\": it is of another scene, its bodies or grids differ");
  return checkpoint;
}

template class Recorder<1>;
template class Recorder<2>;
template Checkpoint read_checkpoint<1>(const std::string&, const Simulation<1>&);
template Checkpoint read_checkpoint<2>(const std::string&, const Simulation<2>&);

}  // namespace mortise
