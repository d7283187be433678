#include "mortise/cases/input/case_checks.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

#include "mortise/cases/input/options.hpp"
#include "mortise/cases/input/solid_checks.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

bool has_background(const CaseDescription& c) { return c.has_gas && !c.layered(); }

void check_grid(const Node& root, const CaseDescription& c) {
  if (!root.find("grid.low")) return;
  for (std::size_t d = 0; d < static_cast<std::size_t>(c.dimension); ++d) {
    const double length = c.domain_high[d] - c.domain_low[d];
    const std::string along = d == 0 ? "x" : "y";
    if (length <= 0)
      reject(root, "grid.high",
             "grid.high must be greater than grid.low along " + along + ", not " + shortest(c.domain_high[d]) +
                 " against " + shortest(c.domain_low[d]));
    if (length < 4 * c.spacing())
      reject(root, "grid.factor",
             "grid.factor = " + shortest(c.grid_factor) + " gives fewer than 4 cells along " + along +
                 ": it must be at least " + shortest(0.4 / length));
    if (c.tile[d] % 2 != 0)
      reject(root, "grid.tile", "grid.tile must be even, not " + std::to_string(c.tile[d]) + " along " + along);
  }
}

void check_boundaries(const Node& root, const CaseDescription& c) {
  for (const char* side : {"bottom", "top"})
    if (c.dimension == 1 && root.find(std::string("boundaries.") + side))
      reject(root, std::string("boundaries.") + side, std::string("boundaries.") + side + " is not there in 1D");
  if ((c.left == "periodic") != (c.right == "periodic"))
    reject(root, "boundaries.left",
           "boundaries.left and boundaries.right must be periodic both or neither, not \"" + c.left + "\" and \"" +
               c.right + "\"");
  if ((c.bottom == "periodic") != (c.top == "periodic"))
    reject(root, "boundaries.bottom",
           "boundaries.bottom and boundaries.top must be periodic both or neither, not \"" + c.bottom + "\" and \"" +
               c.top + "\"");
  if (c.has_inflow && c.inflow[0] == 0)
    reject(root, "boundaries", "the key \"boundaries.inflow\" is missing: the state of the gas at inflow sides");
  if (c.layered() && !c.solids.empty() && c.solids[0].annulus())
    for (const char* side : {"boundaries.left", "boundaries.right"})
      if (root.find(side)) reject(root, side, std::string(side) + " is not there: the gas is a ring");
  for (const auto& [side, kind] : {std::pair{"left", c.left}, {"right", c.right}, {"bottom", c.bottom}, {"top", c.top}})
    if (kind == "exact" && c.exact.empty())
      reject(root, std::string("boundaries.") + side,
             std::string("boundaries.") + side + " = \"exact\" needs an exact solution: the key \"exact\" is missing");
}

void check_regions(const Node& root, const CaseDescription& c) {
  const auto& regions = c.initial.regions;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const std::string path = "initial.regions." + std::to_string(k);
    const bool last = k + 1 == regions.size();
    if (last && !regions[k].where.empty())
      reject(root, path + ".where", path + ".where is not allowed: the last region is everywhere else");
    if (!last && regions[k].where.empty())
      reject(root, path, "the key \"" + path + ".where\" is missing: only the last region is everywhere else");
    for (const auto& [key, formula] : {std::pair{"density", regions[k].density}, {"pressure", regions[k].pressure}}) {
      const Node* given = root.find(path + "." + key);
      const double low = key == std::string_view("density") ? 0 : 0 - c.p_inf;
      if (given && given->is_number() && given->number <= low)
        reject(root, path + "." + key,
               path + "." + key + " = " + formula + " is not allowed: it must be > " + shortest(low));
    }
  }
  if (c.initial.kind == "regions" && regions.empty())
    reject(root, "initial.regions", "initial.regions must not be empty");
}

void check_initial(const Node& root, const CaseDescription& c) {
  if (c.dimension == 1 && c.solids.empty() && root.find("initial.angle"))
    reject(root, "initial.angle", "initial.angle is not there in 1D");
  if (c.dimension == 1 && c.initial.angle != 0 && c.initial.angle != 180)
    reject(root, "initial.angle", "initial.angle must be 0 or 180 in 1D, not " + shortest(c.initial.angle));
  if (c.dimension == 1 && c.initial.kind == "vortex")
    reject(root, "initial.kind", "initial.kind = \"vortex\" is not there in 1D");
  if (c.initial.kind == "exact" && c.exact.empty())
    reject(root, "initial.kind", "initial.kind = \"exact\" needs an exact solution: the key \"exact\" is missing");
  if (c.initial.kind == "exact" && !root.find("initial.state") && !c.solids.empty())
    reject(root, "initial", "the key \"initial.state\" is missing: the gas that the exact solution is made from");
  check_regions(root, c);
  const double b = c.initial.strength;
  const double coldest =
      1 - (c.gamma - 1) * b * b * std::numbers::e / (8 * c.gamma * std::numbers::pi * std::numbers::pi);
  if (c.initial.kind == "vortex" && coldest <= 0)
    reject(root, "initial.strength",
           "initial.strength = " + shortest(b) + " is too strong: the temperature in the vortex would be " +
               shortest(coldest));
}

void check_exact(const Node& root, const CaseDescription& c) {
  struct Need {
    const char* key;
    std::vector<std::string> kinds;  // initial kinds; empty: any
    int dimension;                   // 0: any
    bool one_body;
    std::vector<std::string> solid = {};  // shapes of its one elastic solid; empty: any scene
  };
  const Need needs[] = {{"riemann", {"riemann", "shock"}, 0, false},
                        {"vortex", {"vortex"}, 2, false},
                        {"uniform", {"uniform"}, 0, false},
                        {"rigid_piston", {}, 1, true},
                        {"shock_on_massless_body", {"shock"}, 1, true},
                        {"weak_shock_on_free_cylinder", {"shock"}, 2, true},
                        {"elastic_piston", {"uniform"}, 0, false, {"strip"}},
                        {"elastic_bar", {"uniform"}, 0, false, {"strip"}},
                        {"elastic_piston_shock", {"shock"}, 0, false, {"strip"}},
                        {"superseismic_shock", {"exact"}, 2, false, {"strip"}},
                        {"deforming_diffuser", {"exact", "uniform"}, 2, false, {"strip"}},
                        {"radial_reference", {"uniform"}, 2, false, {"annulus", "circle"}},
                        {"plane_waves", {}, 2, false, {"plate"}},
                        {"annulus_modes", {}, 2, false, {"annulus"}},
                        {"rayleigh_wave", {}, 2, false, {"plate"}}};
  for (const Need& need : needs) {
    if (c.exact != need.key) continue;
    const std::string exact = "exact = \"" + c.exact + "\" needs ";
    if (!need.kinds.empty() && std::find(need.kinds.begin(), need.kinds.end(), c.initial.kind) == need.kinds.end())
      reject(root, "exact", exact + "initial.kind = " + need.kinds.front() + ", not " + c.initial.kind);
    if (need.dimension != 0 && need.dimension != c.dimension)
      reject(root, "exact", exact + "dimension = " + std::to_string(need.dimension));
    if (need.one_body && c.bodies.size() != 1)
      reject(root, "exact", exact + "one body, not " + std::to_string(c.bodies.size()));
    if (!need.solid.empty() && (c.solids.size() != 1 ||
                                std::find(need.solid.begin(), need.solid.end(), c.solids[0].shape) == need.solid.end()))
      reject(root, "exact", exact + "one elastic solid with shape = " + joined(need.solid));
    if (!need.solid.empty() && c.solids[0].material.law != "linear")
      reject(root, "exact",
             exact + "material.law = linear, not " + c.solids[0].material.law + ": use none, or the linear law");
  }
}

bool inside(const std::array<double, 2>& x, const CaseDescription& c) {
  for (std::size_t d = 0; d < static_cast<std::size_t>(c.dimension); ++d)
    if (x[d] < c.domain_low[d] || x[d] > c.domain_high[d]) return false;
  return true;
}

/// Something with a name, and the path of its table.
struct Named {
  std::string path, name;
};

/// Names become columns, blocks and files.
void check_names(const Node& root, const std::vector<Named>& all) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string &name = all[k].name, path = all[k].path + ".name";
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    if (!plain || name.empty())
      reject(root, path, path + " = \"" + name + "\" is not allowed: use letters, digits, _ and -");
    if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k),
                    [&](const Named& other) { return other.name == name; }))
      reject(root, path, path + " = \"" + name + "\" is the name of another one, too");
  }
}

void check_place(const Node& root, const CaseDescription& c, const std::string& path, const std::array<double, 2>& x) {
  if (!inside(x, c)) reject(root, path + ".position", path + ".position is outside the domain");
}

void check_places(const Node& root, const CaseDescription& c) {
  std::vector<Named> structures, probes;
  for (std::size_t k = 0; k < c.bodies.size(); ++k) {
    structures.push_back({"bodies." + std::to_string(k), c.bodies[k].name});
    check_place(root, c, structures.back().path, c.bodies[k].position);
  }
  bool background_is_all = has_background(c);
  for (std::size_t k = 0; k < c.solids.size(); ++k) {
    structures.push_back({"solids." + std::to_string(k), c.solids[k].name});
    background_is_all = background_is_all && c.solids[k].immersed();
    if (has_background(c)) check_place(root, c, structures.back().path, c.solids[k].position);
  }
  for (std::size_t k = 0; k < c.probes.size(); ++k) {
    probes.push_back({"probes." + std::to_string(k), c.probes[k].name});
    if (background_is_all) check_place(root, c, probes.back().path, c.probes[k].position);
  }
  check_names(root, structures);
  check_names(root, probes);
}

/// Keys that only some scenes need.
void check_required(const Node& root, const CaseDescription& c) {
  const auto need = [&](const std::string& table, const std::string& key, const char* allowed) {
    if (!root.find(table + "." + key))
      reject(root, table, "the key \"" + table + "." + key + "\" is missing: " + allowed);
  };
  if (!c.has_gas) return;
  const bool ring = c.layered() && !c.solids.empty() && c.solids[0].annulus();
  if (!ring) need("grid", "low", "the corner of the domain with the smallest coordinates");
  if (!ring) need("grid", "high", "the corner of the domain with the largest coordinates");
  need("initial", "kind", "how the gas is at t = 0: uniform, shock, riemann, vortex, regions or exact");
}

/// What an incompressible fluid can be in, and a gas cannot.
void check_fluid(const Node& root, const CaseDescription& c) {
  for (const auto& [side, kind] : {std::pair{"left", c.left}, {"right", c.right}, {"bottom", c.bottom}, {"top", c.top}}) {
    const std::string path = std::string("boundaries.") + side;
    if (!c.incompressible() && kind == "slip_wall") reject(root, path, path + " = \"slip_wall\" is for incompressible fluids: walls of gas are, all of them");
    if (c.incompressible() && kind == "exact") reject(root, path, path + " = \"exact\" is not there with fluid.kind = \"incompressible\"");
  }
  for (std::size_t k = 0; k < c.solids.size(); ++k)
    for (const auto& [key, given] : {std::pair{"actuation", !c.solids[k].actuation.empty()}, {"viscosity", c.solids[k].viscosity != 0}, {"anchors", !c.solids[k].anchors.empty()}})
      if (given && !c.incompressible())
        reject(root, "solids." + std::to_string(k), "solids." + std::to_string(k) + "." + key + " needs fluid.kind = \"incompressible\"");
  if (!c.incompressible()) return;
  const std::string fluid = "fluid.kind = \"incompressible\" ";
  if (c.dimension != 2 || c.layered()) reject(root, "fluid.kind", fluid + "needs dimension = 2 and grid.kind = \"overlapping\"");
  if (c.initial.kind != "uniform" && c.initial.kind != "regions")
    reject(root, "fluid.kind", fluid + "has no " + c.initial.kind + ": initial.kind can be uniform or regions");
  if (!c.bodies.empty()) reject(root, "fluid.kind", fluid + "moves no rigid bodies");
  if (!c.exact.empty()) reject(root, "fluid.kind", fluid + "has no exact solution to compare with");
  if (!c.solids.empty() && c.scheme != "reference-map") reject(root, "scheme", fluid + "needs scheme = \"reference-map\" for its solids, not \"" + c.scheme + "\"");
  for (const SolidDescription& solid : c.solids)
    if (solid.material.law != "neo_hookean") reject(root, "fluid.kind", fluid + "needs material.law = \"neo_hookean\", and " + solid.name + " has \"" + solid.material.law + "\"");
  for (const std::string& picture : c.pictures)
    if (picture == "schlieren" || picture == "mach")
      reject(root, "output.pictures", "the picture \"" + picture + "\" of output.pictures needs gas; with an incompressible fluid: vorticity, pressure, velocity, stress");
}

void check_output(const Node& root, const CaseDescription& c) {
  const bool mapped = c.scheme == "reference-map" && !c.solids.empty();
  if (c.contours && !mapped)
    reject(root, "output.contours", "output.contours = true shows reference maps: it needs scheme = \"reference-map\"");
  if (!c.oscillation) return;
  const std::string key = "output.oscillation";
  if (!mapped || !c.incompressible() || c.probes.empty())
    reject(root, key,
           key + " needs scheme = \"reference-map\", fluid.kind = \"incompressible\" and at least one of probes");
  const auto [begin, end] = *c.oscillation;
  if (end <= begin || end > c.time_end)
    reject(root, key,
           key + " = [" + shortest(begin) + ", " + shortest(end) +
               "] is not allowed: it must be [from, to] with from < to ≤ time.end = " + shortest(c.time_end));
}

void check_scheme(const Node& root, const CaseDescription& c) {
  const auto wet = std::find_if(c.solids.begin(), c.solids.end(), [](const auto& b) { return b.wet(); });
  const bool interfaces = wet != c.solids.end();
  const std::string scheme = "scheme = \"" + c.scheme + "\"";
  const auto known = [&](const std::vector<std::string>& schemes) {
    return std::find(schemes.begin(), schemes.end(), c.scheme) != schemes.end();
  };
  if (interfaces && !known(options::interface_schemes))
    reject(root, "scheme",
           scheme + " leaves the interface of solids." + std::to_string(wet - c.solids.begin()) + " (" + wet->name +
               ") without a scheme: use " + joined(options::interface_schemes));
  if (interfaces) return;
  if (c.scheme == "none" && !c.bodies.empty())
    reject(root, "scheme", scheme + " cannot move bodies: use rigid or traditional");
  if (c.scheme != "none" && c.bodies.empty() && known(options::body_schemes))
    reject(root, "scheme", scheme + " needs bodies and the case has none: use none, or omit the scheme");
  if (c.scheme != "none" && !known(options::body_schemes))
    reject(root, "scheme",
           scheme + " needs an elastic solid in gas and the case has none: " +
               (c.bodies.empty() ? "use none, or omit the scheme" : "use rigid or traditional"));
}

}  // namespace

std::array<double, 4> gas_behind_shock(const std::array<double, 4>& ahead, double mach, const std::array<double, 2>& n,
                                       double gamma, double p_inf) {
  const double shifted = ahead[3] + p_inf, m2 = mach * mach;
  const double jump = std::sqrt(gamma * shifted / ahead[0]) * 2 * (m2 - 1) / ((gamma + 1) * mach);  // of n·u
  return {ahead[0] * (gamma + 1) * m2 / ((gamma - 1) * m2 + 2), ahead[1] + jump * n[0], ahead[2] + jump * n[1],
          shifted * (1 + 2 * gamma / (gamma + 1) * (m2 - 1)) - p_inf};
}

void complete_case(const Node& root, CaseDescription& c) {
  if (c.title.empty()) c.title = c.name;
  if (c.output.empty()) c.output = "output/" + c.name;
  InitialDescription& i = c.initial;
  if (i.kind == "uniform" || i.kind == "exact") i.left = i.right = i.state;
  if (i.kind == "shock" && i.mach > 0) {
    const double radians = i.angle * std::numbers::pi / 180;
    i.left = gas_behind_shock(i.right, i.mach, {std::cos(radians), std::sin(radians)}, c.gamma, c.p_inf);
  }
  if (c.incompressible() && !root.find("output.pictures")) c.pictures = {"vorticity"};
  complete_solids(root, c);
  const bool interfaces = std::any_of(c.solids.begin(), c.solids.end(), [](const auto& b) { return b.wet(); });
  if (!root.find("scheme")) c.scheme = interfaces ? "projection" : c.bodies.empty() ? "none" : "rigid";
  c.has_inflow = c.left == "inflow" || c.right == "inflow" || c.bottom == "inflow" || c.top == "inflow";
  if (!root.find("boundaries.inflow") && (i.kind == "uniform" || i.kind == "shock")) c.inflow = i.left;
  for (std::size_t k = 0; k < c.bodies.size(); ++k) {
    BodyDescription& b = c.bodies[k];
    b.place = root.find("bodies." + std::to_string(k))->place;
    if (b.name.empty()) b.name = b.shape + "_" + std::to_string(k);
    if (!b.points.empty()) b.points = (std::filesystem::path(c.folder) / b.points).string();
  }
  for (std::size_t k = 0; k < c.probes.size(); ++k)
    if (c.probes[k].name.empty()) c.probes[k].name = "probe_" + std::to_string(k);
}

void check_case(const Node& root, const CaseDescription& c) {
  check_required(root, c);
  check_grid(root, c);
  check_boundaries(root, c);
  check_initial(root, c);
  check_exact(root, c);
  check_scheme(root, c);
  check_fluid(root, c);
  for (std::size_t k = 0; k < c.bodies.size(); ++k) check_body(root, c, k);
  check_solids(root, c);
  check_output(root, c);
  check_places(root, c);
}

}  // namespace mortise
