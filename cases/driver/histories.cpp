#include "mortise/cases/driver/histories.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/driver/interface_measures.hpp"
#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/solid/elastic_measures.hpp"

namespace mortise {
namespace {

const std::vector<std::string> body_columns = {"t",  "body",  "x",  "y",  "angle", "vx",
                                               "vy", "omega", "fx", "fy", "torque"};
const std::vector<std::string> probe_columns = {"t", "probe", "density", "velocity_x", "velocity_y", "pressure"};
const std::vector<std::string> solid_probe_columns = {
    "t",          "probe",      "x",         "y",         "displacement_x", "displacement_y",
    "velocity_x", "velocity_y", "stress_xx", "stress_xy", "stress_yy"};
const std::vector<std::string> interface_columns = {"t",       "interface", "x_min",    "x_max",      "y_min",
                                                    "y_max",   "area",      "pressure", "velocity_x", "velocity_y",
                                                    "force_x", "force_y",   "least_j"};

CsvWriter open_history(const std::string& path, const std::vector<std::string>& columns,
                       std::optional<double> resume_time) {
  return resume_time ? CsvWriter::truncate_after(path, columns, *resume_time) : CsvWriter(path, columns);
}

template <int Dim>
Point<2> in_plane(const Point<Dim>& x) {
  return {x[0], Dim == 2 ? x[Dim - 1] : 0.0};
}

/// The solid that holds a reference point; −1: none. Collective.
template <int Dim>
int solid_at(const Simulation<Dim>& simulation, const Point<Dim>& X) {
  const std::vector<Point<2>> point{in_plane<Dim>(X)};
  for (std::size_t k = 0; k < simulation.solids().size(); ++k)
    if (!std::isnan(simulation.solids()[k]->sample(point)[0][0])) return static_cast<int>(k);
  const std::vector<MappedSolid> mapped = mapped_solids(simulation);
  for (std::size_t b = 0; b < mapped.size(); ++b)
    if (mapped[b].map->level_set()(point[0].x(), point[0].y()) < 0) return static_cast<int>(b);
  return -1;
}

/// Elastic solids, or bodies of a reference map.
template <int Dim>
std::size_t solid_count(const Simulation<Dim>& simulation) {
  return simulation.solids().size() + mapped_solids(simulation).size();  // either these or those
}

}  // namespace

template <int Dim>
Histories<Dim>::Histories(const CaseDescription& description, const Simulation<Dim>& simulation)
    : solid_probes_(solid_count(simulation)),
      has_bodies_(!simulation.bodies().empty()),
      has_interfaces_(!simulation.interfaces().empty()) {
  for (const ProbeDescription& probe : description.probes) {
    Point<Dim> x;
    for (int d = 0; d < Dim; ++d) x[d] = probe.position[static_cast<std::size_t>(d)];
    const int solid = solid_at<Dim>(simulation, x);
    Probes& of = solid < 0 ? fluid_probes_ : solid_probes_[static_cast<std::size_t>(solid)];
    of.names.push_back(probe.name);
    of.points.push_back(x);
  }
}

template <int Dim>
void Histories<Dim>::open(const std::string& directory, std::optional<double> resume_time) {
  const auto in_solid = [](const Probes& probes) { return !probes.names.empty(); };
  const auto start = [&](std::optional<CsvWriter>& file, const char* name, const std::vector<std::string>& columns) {
    file.emplace(open_history(directory + name, columns, resume_time));
  };
  if (has_bodies_) start(bodies_, "/bodies.csv", body_columns);
  if (!fluid_probes_.names.empty()) start(probes_, "/probes.csv", probe_columns);
  if (std::any_of(solid_probes_.begin(), solid_probes_.end(), in_solid))
    start(solids_, "/solid_probes.csv", solid_probe_columns);
  if (has_interfaces_) start(interfaces_, "/interface.csv", interface_columns);
}

template <int Dim>
void Histories<Dim>::add_bodies(const Simulation<Dim>& simulation, std::vector<Row>& rows) const {
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
    const RigidBody<Dim>& body = simulation.bodies()[b];
    const BodyLoad<Dim>& load = simulation.loads()[b];
    const Point<2> x = in_plane<Dim>(body.pose.position), v = in_plane<Dim>(body.y.template head<Dim>()),
                   force = in_plane<Dim>(load.force);
    const double omega = Dim == 2 ? body.y[degrees_of_freedom<Dim> - 1] : 0.0;
    rows.push_back({simulation.time(), body.name, x[0], x[1], body.pose.angle, v[0], v[1], omega, force[0], force[1],
                    load.torque});
  }
}

template <int Dim>
void Histories<Dim>::add_probes(const Simulation<Dim>& simulation, std::vector<Row>& rows) const {
  if (fluid_probes_.points.empty()) return;
  const auto values = simulation.fluid().sample(fluid_probes_.points);
  const double p_inf = simulation.fluid().setup().gas.p_inf;
  for (std::size_t p = 0; p < values.size(); ++p)
    rows.push_back({simulation.time(), fluid_probes_.names[p], values[p][0], values[p][1],
                    Dim == 2 ? values[p][Dim] : 0.0, values[p][Dim + 1] - p_inf});
}

template <int Dim>
void Histories<Dim>::add_solid_probes(const Simulation<Dim>& simulation, std::size_t solid,
                                      std::vector<Row>& rows) const {
  const Probes& probes = solid_probes_[solid];
  if (probes.points.empty()) return;
  std::vector<Point<2>> points;
  for (const Point<Dim>& X : probes.points) points.push_back(in_plane<Dim>(X));
  Material material;
  std::vector<ElasticState> states;
  if (const std::vector<MappedSolid> mapped = mapped_solids(simulation); !mapped.empty()) {
    material = mapped[solid].material;
    for (const Point<2>& X : points) states.push_back(material_point(mapped[solid], X).value_or(MappedPoint{}).state);
  } else {
    material = simulation.solids()[solid]->setup().options.material;
    states = simulation.solids()[solid]->sample(points);
  }
  for (std::size_t p = 0; p < states.size(); ++p) {
    const Point<2> u = displacement_of(material, states[p]), v = velocity_of(states[p]), x = points[p] + u;
    const CauchyStress s = cauchy_stress_of(material, states[p]);
    rows.push_back({simulation.time(), probes.names[p], x[0], x[1], u[0], u[1], v[0], v[1], s.xx, s.xy, s.yy});
  }
}

template <int Dim>
void Histories<Dim>::add_interfaces(const Simulation<Dim>& simulation, std::vector<Row>& rows) const {
  if (!has_interfaces_) return;
  for (const InterfaceState& interface : simulation.interfaces()) {
    const InterfaceMeasures m = measure(interface, simulation.fluid().setup().gas.p_inf);
    double least_j = 1;
    for (const auto& solid : simulation.solids())
      if (solid->setup().name == interface.name) least_j = solid->least_j();
    rows.push_back({simulation.time(), interface.name, m.box.low[0], m.box.high[0], m.box.low[1], m.box.high[1], m.area,
                    m.pressure, m.velocity[0], m.velocity[1], m.force[0], m.force[1], least_j});
  }
}

template <int Dim>
std::function<void()> Histories<Dim>::rows(const Simulation<Dim>& simulation) {
  std::vector<Row> bodies, probes, solids, interfaces;
  add_bodies(simulation, bodies);
  add_probes(simulation, probes);
  for (std::size_t k = 0; k < solid_probes_.size(); ++k) add_solid_probes(simulation, k, solids);
  add_interfaces(simulation, interfaces);
  return [=, this] {
    for (const Row& row : bodies) bodies_->row(row);
    for (const Row& row : probes) probes_->row(row);
    for (const Row& row : solids) solids_->row(row);
    for (const Row& row : interfaces) interfaces_->row(row);
  };
}

template class Histories<1>;
template class Histories<2>;

}  // namespace mortise
