#include "mortise/cases/summary/summary.hpp"

#include <nlohmann/json.hpp>

#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const BodySummary& body) {
  return {{"name", body.name},
          {"position", body.position},
          {"angle", body.angle},
          {"velocity", body.velocity},
          {"angular_velocity", body.angular_velocity}};
}

Json to_json(const SolidSummary& solid) {
  return {{"name", solid.name},
          {"law", solid.law},
          {"mass", solid.mass},
          {"position", solid.position},
          {"velocity", solid.velocity},
          {"momentum", solid.momentum},
          {"angular_momentum", solid.angular_momentum},
          {"kinetic_energy", solid.kinetic_energy},
          {"strain_energy", solid.strain_energy},
          {"least_j", solid.least_j},
          {"max_von_mises", solid.max_von_mises}};
}

Json to_json(const InterfaceSummary& interface) {
  return {{"name", interface.name},  {"low", interface.low},           {"high", interface.high},
          {"area", interface.area},  {"pressure", interface.pressure}, {"velocity", interface.velocity},
          {"force", interface.force}};
}

Json to_json(const OscillationSummary& found) {
  return {{"probe", found.probe},
          {"component", found.component},
          {"mean", found.oscillation.mean},
          {"amplitude", found.oscillation.amplitude},
          {"frequency", found.oscillation.frequency},
          {"half_range", found.oscillation.half_range},
          {"rms_amplitude", found.oscillation.rms_amplitude},
          {"mean_frequency", found.oscillation.mean_frequency}};
}

template <class Item>
Json list(const std::vector<Item>& items) {
  Json all = Json::array();
  for (const Item& item : items) all.push_back(to_json(item));
  return all;
}

Json to_json(const Provenance& made_by, const std::string& case_text) {
  return {{"version", made_by.version},   {"git", made_by.git},     {"dirty", made_by.dirty},
          {"compiler", made_by.compiler}, {"flags", made_by.flags}, {"case_text", case_text}};
}

Json to_json(const RunSummary& run) {
  Json json = {{"case", run.case_name},
               {"scheme", run.scheme},
               {"status", run.status},
               {"reason", run.reason},
               {"time", run.time},
               {"steps", run.steps},
               {"ranks", run.ranks},
               {"wall_seconds", run.wall_seconds},
               {"cell_updates", run.cell_updates}};
  json["cell_updates_per_second"] = run.wall_seconds > 0 ? run.cell_updates / run.wall_seconds : 0.0;
  json["skipped_fraction"] = run.skipped_fraction;
  json["phases"] = run.phases;
  json["memory_bytes"] = run.memory_bytes;
  json["cells"] = Json::object();
  for (const auto& [grid, count] : run.cells) json["cells"][grid] = count;
  if (!run.errors.empty()) json["errors"] = Json::object();
  for (const auto& [quantity, norms] : run.errors)
    json["errors"][quantity] = {{"l1", norms.l1}, {"l2", norms.l2}, {"max", norms.max}};
  if (run.conservation)
    json["conservation"] = {{"mass", run.conservation->mass},
                            {"momentum", run.conservation->momentum},
                            {"energy", run.conservation->energy}};
  json["bodies"] = list(run.bodies);
  json["solids"] = list(run.solids);
  json["interfaces"] = list(run.interfaces);
  if (!run.oscillations.empty()) json["oscillations"] = list(run.oscillations);
  json["overlap"] = {{"orphans", run.overlap.orphans},
                     {"fringe", run.overlap.fringe},
                     {"holes", run.overlap.holes},
                     {"tight", run.overlap.tight}};
  json["contacts"] = run.contacts;
  json["repeated_steps"] = run.repeated_steps;
  json["first_order_steps"] = run.first_order_steps;
  json["provenance"] = to_json(run.provenance, run.case_text);
  return json;
}

}  // namespace

void write_summary(const RunSummary& summary, const std::string& path) {
  write_file(path, to_json(summary).dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace mortise
