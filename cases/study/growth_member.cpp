#include "mortise/cases/study/growth_member.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/study/growth.hpp"
#include "mortise/cases/study/prediction.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

using Json = nlohmann::ordered_json;

double number(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

int write_growth(GrowthMemberOptions options) {
  const CaseDescription description = read_case(options.case_name, options.overrides, options.cases_root);
  DisturbanceOptions disturbance;
  disturbance.steps = options.steps;
  disturbance.along_wall = options.along_wall;
  const Growth growth = measure_growth(description, disturbance);
  Json json = {{"status", growth.status}, {"reason", growth.reason},
               {"time", growth.time},     {"steps", growth.steps},
               {"factor", growth.factor}, {"rate", growth.rate},
               {"dt", growth.dt},         {"window", {growth.first, growth.last}}};
  std::string why;
  if (const auto prediction = predict_growth(description, &why)) {
    json["predicted"] = prediction->factor;
    json["predicted_along_wall_at_most"] = prediction->along_wall;
    json["predicted_rate"] = prediction->rate;
    json["ratio"] = prediction->ratio;
  }
  json["not_predicted"] = why;
  json["energy"] = growth.energy;
  write_file(options.output, json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
  return growth.status == "unstable" ? 3 : 0;
}

GrowthRecord read_growth(const std::string& path) {
  const Json json = Json::parse(read_file(path), nullptr, false);
  if (json.is_discarded()) throw EnvironmentError("\"" + path + "\" cannot be read");
  GrowthRecord record;
  record.status = json.value("status", "");
  record.reason = json.value("reason", "");
  record.not_predicted = json.value("not_predicted", "");
  record.time = number(json, "time");
  record.steps = number(json, "steps");
  record.factor = number(json, "factor");
  record.rate = number(json, "rate");
  record.dt = number(json, "dt");
  record.predicted = number(json, "predicted");
  record.predicted_rate = number(json, "predicted_rate");
  record.ratio = number(json, "ratio");
  return record;
}

}  // namespace mortise
