// What has been published about gas with elastic solids, and how our runs are read for it.
#include <nlohmann/json.hpp>

#include "mortise/cases/study/comparison_parts.hpp"
#include "mortise/cases/study/snapshot_difference.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise::published {

namespace {

constexpr PublishedError piston_errors[] = {{"fluid.density", 5.98e-7},     {"fluid.velocity_x", 5.98e-6},
                                            {"fluid.temperature", 1.71e-6}, {"solid.displacement", 8.0e-7},
                                            {"solid.velocity", 2.1e-7},     {"solid.stress", 2.1e-7}};
constexpr PublishedError turned_errors[] = {{"fluid.density", 5.85e-7},     {"fluid.velocity", 4.14e-6},
                                            {"fluid.temperature", 2.18e-6}, {"solid.displacement", 5.8e-7},
                                            {"solid.velocity", 1.8e-7},     {"solid.stress", 2.1e-7}};
struct PistonRun {
  double factor, density, seconds;
};
constexpr PistonRun piston_runs[] = {{4, 3.34e-5, 0.91}, {8, 9.00e-6, 2.33}, {16, 2.36e-6, 7.45}, {32, 6.07e-7, 26.7}};

}  // namespace

Comparison elastic_piston() {
  Comparison comparison{"elastic_piston", {}, nullptr};
  for (const PistonRun& run : piston_runs)
    comparison.members.push_back(
        member("piston_f" + text(run.factor, "%g"), "elastic_piston", {override_of("grid.factor", run.factor)}));
  comparison.members.push_back(member(
      "piston_turned", "elastic_piston",
      {"grid.factor=32", "dimension=2", "grid.angle=45", "grid.low=[-0.05,0]", "grid.high=[0.05,1]",
       "initial.state=[0.1,0,0,0.07142857142857142]", "boundaries={left=\"exact\", right=\"exact\", top=\"exact\"}",
       "solids.0.sides={left=\"exact\", right=\"exact\", back=\"exact\"}"},
      10));
  comparison.tables = [](Results results) {
    Table fields;
    fields.title = "elastic_piston, F = 32, t = 0.7: largest errors (published at CFL 0.8; ours at 0.9)";
    fields.columns = {{"quantity", "quantity", ""},
                      {"published", "published", "%.2e"},
                      {"ours", "mortise", "%.2e"},
                      {"published_turned", "published, turned by 45°", "%.2e"},
                      {"ours_turned", "mortise, turned", "%.2e"}};
    for (std::size_t k = 0; k < std::size(piston_errors); ++k) {
      const std::string quantity = turned_errors[k].quantity;
      const double turned = quantity == "fluid.velocity"
                                ? std::max(error(results[4], "fluid.velocity_x", &ErrorNorms::max),
                                           error(results[4], "fluid.velocity_y", &ErrorNorms::max))
                                : error(results[4], quantity, &ErrorNorms::max);
      fields.rows.push_back({quantity_heading(piston_errors[k].quantity), piston_errors[k].published,
                             error(results[3], piston_errors[k].quantity, &ErrorNorms::max), turned_errors[k].published,
                             turned});
    }
    Table cost;
    cost.title = "elastic_piston: largest density error and run time";
    cost.columns = {{"factor", "F", "%g"},
                    {"independent", "independent", "%.2e"},
                    {"independent_seconds", "seconds", "%.3g"},
                    {"ours", "mortise", "%.2e"},
                    {"seconds", "seconds", "%.2g"}};
    for (std::size_t k = 0; k < std::size(piston_runs); ++k)
      cost.rows.push_back({piston_runs[k].factor, piston_runs[k].density, piston_runs[k].seconds,
                           error(results[k], "fluid.density", &ErrorNorms::max), results[k].seconds});
    return std::vector<Table>{fields, cost};
  };
  return comparison;
}

namespace {

struct SuperseismicErrors {
  const char* quantity;
  double independent[3];  // mean errors at F = 4, 8, 16
  double rate;            // published
};
constexpr SuperseismicErrors superseismic[] = {
    {"fluid.density", {4.92e-3, 2.84e-3, 1.77e-3}, .94},     {"fluid.velocity_x", {1.10e-2, 6.27e-3, 3.96e-3}, 1.03},
    {"fluid.temperature", {2.20e-3, 1.30e-3, 8.31e-4}, .88}, {"solid.displacement", {2.03e-4, 7.38e-5, 4.38e-5}, 1.24},
    {"solid.velocity", {3.68e-3, 2.21e-3, 1.36e-3}, .72},    {"solid.stress", {1.98e-3, 1.19e-3, 7.31e-4}, .72}};

}  // namespace

Comparison superseismic_shock() {
  Comparison comparison{"superseismic_shock", {}, nullptr};
  for (const double factor : {4.0, 8.0, 16.0, 32.0})
    comparison.members.push_back(member("superseismic_f" + text(factor, "%g"), "superseismic_shock",
                                        {override_of("grid.factor", factor)}, std::pow(factor / 8, 3)));
  comparison.tables = [](Results results) {
    Table table;
    table.title = "superseismic_shock, t = 0.5, CFL 0.9: mean errors (independent: fails at F = 32)";
    table.columns = {{"quantity", "quantity", ""}};
    for (const char* factor : {"4", "8", "16"}) {
      table.columns.push_back(
          {std::string("independent_") + factor, std::string("independent, F = ") + factor, "%.2e"});
      table.columns.push_back({std::string("ours_") + factor, "mortise", "%.2e"});
    }
    table.columns.insert(table.columns.end(), {{"ours_32", "mortise, F = 32", "%.2e"},
                                               {"published_rate", "published rate", "%.2f"},
                                               {"rate", "mortise, F = 4 to 16", "%.2f"}});
    for (const SuperseismicErrors& line : superseismic) {
      std::vector<TableValue> row = {quantity_heading(line.quantity)};
      std::vector<double> ours;
      for (std::size_t k = 0; k < 4; ++k) {
        ours.push_back(error(results[k], line.quantity, &ErrorNorms::l1));
        if (k < 3) row.push_back(line.independent[k]);
        row.push_back(ours.back());
      }
      const auto rate = fitted_order({0.025, 0.0125, 0.00625}, {ours[0], ours[1], ours[2]});
      row.insert(row.end(), {line.rate, rate ? *rate : nothing});
      table.rows.push_back(row);
    }
    return std::vector<Table>{table};
  };
  return comparison;
}

namespace {

struct Weight {
  const char* name;
  double scale;
  const char* traditional;  // published
};
constexpr Weight weights[] = {{"light", .1, "fails"}, {"medium", 1, "fails"}, {"heavy", 10, "works"}};
constexpr PublishedError cylinder_rates[] = {{"fluid.density", .88},     {"fluid.velocity_x", .87},
                                             {"fluid.temperature", .88}, {"solid.displacement", 1.08},
                                             {"solid.velocity", .72},    {"solid.stress", .71}};

std::string verdict(const MemberResult& result) {
  return result.finished() ? "works" : "fails at t = " + text(result.time, "%.2g");
}

nlohmann::json interface_of(const MemberResult& result) {
  return nlohmann::json::parse(read_file(result.directory + "/summary.json")).at("interfaces").at(0);
}

}  // namespace

Comparison cylinder_in_solid() {
  Comparison comparison{"cylinder_in_solid", {}, nullptr};
  const Overrides probe = {"probes=[{name=\"centre\", position=[0,0]}]"};
  for (const Weight& weight : weights)
    for (const char* scheme : {"projection", "traditional"})
      comparison.members.push_back(
          member(std::string("cylinder_") + weight.name + "_" + scheme, "cylinder_in_solid",
                 probe + Overrides{"grid.factor=8", "time.end=1.5", override_of("solid.scale", weight.scale),
                                   std::string("scheme=") + scheme},
                 30));
  for (const double factor : {4.0, 8.0, 16.0})
    comparison.members.push_back(member("cylinder_light_f" + text(factor, "%g"), "cylinder_in_solid",
                                        {override_of("grid.factor", factor), "time.end=1", "solid.scale=0.1"},
                                        std::pow(factor / 3, 3), true));
  comparison.tables = [](Results results) {
    Table schemes;
    schemes.title = "cylinder_in_solid: which coupling works (F = 8, t = 1.5)";
    schemes.columns = {{"solid", "solid", ""},
                       {"ratio", "z_s/z_f", "%.2g"},
                       {"published_projection", "projection, published", ""},
                       {"projection", "mortise", ""},
                       {"published_traditional", "traditional, published", ""},
                       {"traditional", "mortise", ""}};
    for (std::size_t k = 0; k < std::size(weights); ++k)
      schemes.rows.push_back({std::string(weights[k].name), weights[k].scale * std::sqrt(3.0), std::string("works"),
                              verdict(results[2 * k]), std::string(weights[k].traditional),
                              verdict(results[2 * k + 1])});
    Table light;
    light.title = "cylinder_in_solid, light, h = .0125";
    light.columns = {{"measure", "measure", ""}, {"independent", "independent", "%.5g"}, {"ours", "mortise", "%.5g"}};
    const nlohmann::json early = interface_of(results[7]), late = interface_of(results[0]);
    const auto centre = read_history(results[0].directory + "/probes.csv", "centre");
    light.rows = {{std::string("leftmost point of the interface, t = 1"), -.9608, early.at("low").at(0).get<double>()},
                  {std::string("enclosed area, t = 1"), 3.0870, early.at("area").get<double>()},
                  {std::string("leftmost point of the interface, t = 1.5"), -.9261, late.at("low").at(0).get<double>()},
                  {std::string("enclosed area, t = 1.5"), 3.0466, late.at("area").get<double>()},
                  {std::string("p at the centre, t = 1.5"), .7710, history_at(centre, "pressure", 1.5)},
                  {std::string("u at the centre, t = 1.5"), .0529, history_at(centre, "velocity_x", 1.5)}};
    Table rates;
    rates.title = "cylinder_in_solid, light, t = 1: rates of self-convergence, L1";
    rates.columns = {
        {"quantity", "quantity", ""}, {"published", "published", "%.2f"}, {"ours", "mortise, F = 4, 8, 16", "%.2f"}};
    const auto coarse = snapshot_difference(last_fields(results[6]), last_fields(results[7])),
               fine = snapshot_difference(last_fields(results[7]), last_fields(results[8]));
    for (const PublishedError& line : cylinder_rates)
      rates.rows.push_back({quantity_heading(line.quantity), line.published,
                            std::log2(coarse.at(line.quantity).l1 / fine.at(line.quantity).l1)});
    return std::vector<Table>{schemes, light, rates};
  };
  return comparison;
}

}  // namespace mortise::published
