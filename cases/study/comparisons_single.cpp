// What has been published about rigid bodies and solids alone, and how our runs are read for it.
#include <numbers>

#include "mortise/cases/study/comparison_parts.hpp"

namespace mortise::published {

Comparison rigid_piston() {
  Comparison comparison{"rigid_piston", {}, nullptr};
  comparison.members = {member("rigid_piston_released", "rigid_piston", {"grid.factor=16"}),
                        member("rigid_piston_driven", "rigid_piston", {"grid.factor=32", "bodies.0.motion.x=-t^4/4"})};
  comparison.tables = [](Results results) {
    Table table;
    table.title = "rigid_piston, t = 1";
    table.columns = {{"measure", "measure", ""}, {"published", "published", "%.2e"}, {"ours", "mortise", "%.2e"}};
    table.rows = {
        {std::string("released, F = 16, L1: ρ"), 6.2e-5, error(results[0], "fluid.density", &ErrorNorms::l1)},
        {std::string("released, F = 16, L1: u"), 4.5e-5, error(results[0], "fluid.velocity_x", &ErrorNorms::l1)},
        {std::string("released, F = 16, L1: T"), 1.3e-5, error(results[0], "fluid.temperature", &ErrorNorms::l1)},
        {std::string("driven, −t⁴/4, F = 32, max: ρ"), 6.0e-6, error(results[1], "fluid.density", &ErrorNorms::max)}};
    return std::vector<Table>{table};
  };
  return comparison;
}

namespace {

struct EllipseAt {
  double time, published[3], independent[3];  // x, y, degrees
};
constexpr EllipseAt ellipse[] = {{.4, {.166, .079, 64.6}, {.1675, .0807, 64.8}},
                                 {.6, {.403, .216, 85.0}, {.4056, .2183, 85.1}},
                                 {1, {.934, .327, 91.8}, {.9368, .3299, 91.65}}};

}  // namespace

Comparison massless_ellipse() {
  Comparison comparison{"massless_ellipse", {member("massless_ellipse", "massless_ellipse", {}, 60)}, nullptr};
  comparison.tables = [](Results results) {
    Table table;
    table.title =
        "massless_ellipse, h = 1/160: centre and angle (published: read off figures, ±.004; independent: 528 s)";
    table.columns = {{"time", "t", "%g"}};
    for (const char* who : {"published", "independent", "mortise"})
      for (const auto& [key, heading] : {std::pair("_x", " x"), std::pair("_y", " y"), std::pair("_angle", " °")})
        table.columns.push_back(
            {std::string(who) + key, std::string(who) + heading, key == std::string("_angle") ? "%.1f" : "%.4g"});
    table.columns.push_back({"seconds", "seconds", "%.2g"});
    const auto history = read_history(results[0].directory + "/bodies.csv", "ellipse");
    for (const EllipseAt& at : ellipse) {
      std::vector<TableValue> row = {at.time};
      for (const double value : at.published) row.push_back(value);
      for (const double value : at.independent) row.push_back(value);
      row.insert(row.end(), {history_at(history, "x", at.time), history_at(history, "y", at.time),
                             history_at(history, "angle", at.time) * 180 / std::numbers::pi, results[0].seconds});
      table.rows.push_back(row);
    }
    return std::vector<Table>{table};
  };
  return comparison;
}

namespace {

constexpr double mode_factors[] = {4, 8, 16};

}  // namespace

Comparison solid_modes() {
  Comparison comparison{"solid_modes", {}, nullptr};
  for (const double factor : mode_factors) {
    const std::string setting = override_of("grid.factor", factor);
    comparison.members.push_back(member("annulus_f" + text(factor, "%g"), "annulus_modes",
                                        {setting, "time.end=2.837", "probes=[{name=\"ring\", position=[0.75,0]}]"}));
    comparison.members.push_back(member(
        "rayleigh_f" + text(factor, "%g"), "rayleigh_wave",
        {setting, "time.end=5.4383", "probes=[{name=\"surface\", position=[0.5,-0.05]}]"}, std::pow(factor / 8, 3)));
  }
  comparison.tables = [](Results results) {
    Table table;
    table.title = "Solids alone: measured over five periods";
    table.columns = {{"measure", "measure", ""}, {"exact", "exact", "%.9g"}};
    for (const double factor : mode_factors)
      table.columns.push_back({"f" + text(factor, "%g"), "mortise, F = " + text(factor, "%g"), "%.6g"});
    table.columns.push_back({"order", "order of the error", "%.2f"});
    struct Mode {
      const char *measure, *item, *column;
      double exact, unit;
      std::size_t first;
    };
    for (const Mode& mode :
         {Mode{"annulus, held at both faces: ω/c_p", "ring", "displacement_x", 6.39315676, std::sqrt(3.0), 0},
          Mode{"Rayleigh wave, λ = μ: c/c_s", "surface", "displacement_y", .9194016867, 2 * std::numbers::pi, 1}}) {
      std::vector<TableValue> row = {std::string(mode.measure), mode.exact};
      std::vector<double> h, deviation;
      for (std::size_t k = 0; k < std::size(mode_factors); ++k) {
        const auto history = read_history(results[2 * k + mode.first].directory + "/solid_probes.csv", mode.item);
        const double measured =
            fitted_frequency(history.at("t"), history.at(mode.column), mode.exact * mode.unit) / mode.unit;
        row.push_back(measured);
        h.push_back(0.1 / mode_factors[k]);
        deviation.push_back(std::abs(measured - mode.exact));
      }
      const auto order = fitted_order(h, deviation);
      row.push_back(order ? *order : nothing);
      table.rows.push_back(row);
    }
    return std::vector<Table>{table};
  };
  return comparison;
}

}  // namespace mortise::published
