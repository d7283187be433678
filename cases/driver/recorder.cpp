#include "mortise/cases/driver/recorder.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "mortise/cases/pictures/render.hpp"
#include "mortise/fluid/cell.hpp"
#include "mortise/grids/core/error.hpp"
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
  if (comm_.rank() != 0) return;
  if (!description_.bodies.empty()) bodies_.emplace(open_history(directory_ + "/bodies.csv", body_columns, resume_time));
  if (!description_.probes.empty()) probes_.emplace(open_history(directory_ + "/probes.csv", probe_columns, resume_time));
  if (description_.hdf5 && description_.frames > 0)
    series_.emplace(directory_, resume_time.value_or(-std::numeric_limits<double>::infinity()));
}

template <int Dim>
void Recorder<Dim>::histories(const Simulation<Dim>& simulation) {
  const double t = simulation.time();
  if (bodies_)
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
      const RigidBody<Dim>& body = simulation.bodies()[b];
      const BodyLoad<Dim>& load = simulation.loads()[b];
      const bool plane = Dim == 2;
      bodies_->row({t, body.name, body.pose.position[0], plane ? body.pose.position[Dim - 1] : 0.0, body.pose.angle, body.y[0],
                    plane ? body.y[Dim - 1] : 0.0, plane ? body.y[degrees_of_freedom<Dim> - 1] : 0.0, load.force[0],
                    plane ? load.force[Dim - 1] : 0.0, load.torque});
    }
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
  for (std::size_t p = 0; probes_ && p < points.size(); ++p)
    probes_->row({t, description_.probes[p].name, values[p][0], values[p][1], Dim == 2 ? values[p][Dim] : 0.0, values[p][Dim + 1] - gas.p_inf});
}

template <int Dim>
void Recorder<Dim>::frame(const Simulation<Dim>& simulation, int number) {
  const Snapshot snapshot = gather_snapshot(simulation);
  if (comm_.rank() != 0) return;
  if (series_) series_->write(snapshot);
  std::error_code ignored;
  std::filesystem::create_directories(directory_ + "/frames", ignored);
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
void Recorder<Dim>::checkpoint(Simulation<Dim>& simulation, int next_frame) {
  const TileRecords tiles = gather_tiles(simulation);
  if (comm_.rank() != 0) return;
  CheckpointWriter writer(directory_ + "/checkpoint.h5");
  writer.write("motion", simulation.motion_state());
  writer.write("tiles", tiles.keys);
  writer.write("rates", tiles.rates);
  writer.write("values", tiles.values);
  writer.write("next_frame", std::vector<std::int64_t>{next_frame});
  writer.write("case", std::vector<std::string>{description_.text});
  writer.finish();
}

template <int Dim>
int read_checkpoint(const std::string& directory, Simulation<Dim>& simulation) {
  const CheckpointReader reader(directory + "/checkpoint.h5");
  const TileRecords tiles{reader.integers("tiles"), reader.doubles("rates"), reader.doubles("values")};
  const std::vector<double> motion = reader.doubles("motion");
  std::int64_t count = 0;
  for (const ComponentGrid<Dim>& grid : simulation.fluid().grids()) count += grid.forest.global_count();
  if (motion.size() != simulation.motion_state().size() || static_cast<std::int64_t>(tiles.rates.size()) != count)
    throw EnvironmentError("cannot read the restart in " + directory + ": it is of another scene (bodies or grids differ)");
  scatter_tiles(tiles, simulation);
  simulation.resume(motion);
  return static_cast<int>(reader.integers("next_frame").at(0));
}

template class Recorder<1>;
template class Recorder<2>;
template int read_checkpoint<1>(const std::string&, Simulation<1>&);
template int read_checkpoint<2>(const std::string&, Simulation<2>&);

}  // namespace mortise
