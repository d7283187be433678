#include "mortise/cases/input/solid_checks.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "mortise/cases/input/options.hpp"
#include "mortise/cases/input/solid_keys.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

using Strings = std::vector<std::string>;

bool among(const std::string& word, const Strings& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Boundaries of one solid and of the gas are the same up to what typing in decimals loses.
bool coincide(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)}); }

/// Sides that are not the interface.
Strings sides_of(const SolidDescription& b, int dimension) {
  if (b.strip()) return dimension == 1 ? Strings{"back"} : Strings{"left", "right", "back"};
  if (b.annulus()) return b.wet() ? Strings{b.gas == "inside" ? "outer" : "inner"} : Strings{"inner", "outer"};
  if (!b.plate()) return b.wet() ? Strings{} : Strings{"outer"};
  Strings sides = {"left", "right", "bottom", "top"};
  if (b.hole > 0 && !b.wet()) sides.emplace_back("inner");
  return sides;
}

Strings gas_places_of(const SolidDescription& b) {
  if (b.strip()) return {"outside"};
  if (b.annulus()) return {"inside", "outside", "none"};
  return b.plate() ? Strings{"inside", "none"} : Strings{"outside", "none"};
}

void complete_sides(CaseDescription& c, SolidDescription& b) {
  const bool repeats = c.dimension == 1 || c.left == "periodic";
  for (SideDescription* side : {&b.left, &b.right})
    if (b.strip() && side->kind.empty() && side->traction.empty()) side->kind = repeats ? "periodic" : "slip";
  for (const auto& [key, side] : side_keys(b))
    if (side->kind.empty()) side->kind = "free";
}

void complete_solid(const Node& root, CaseDescription& c, std::size_t k) {
  SolidDescription& b = c.solids[k];
  b.place = root.find("solids." + std::to_string(k))->place;
  if (b.name.empty()) b.name = b.shape + "_" + std::to_string(c.bodies.size() + k);
  if (b.gas.empty()) b.gas = b.annulus() || b.plate() ? "none" : "outside";
  if (!b.points.empty()) b.points = (std::filesystem::path(c.folder) / b.points).string();
  MaterialDescription& m = b.material;
  if (m.law.empty()) m.law = b.immersed() && b.wet() ? "neo_hookean" : "linear";
  for (double* value : {&m.density, &m.lambda, &m.mu}) *value *= c.solid.scale;
  if (b.initial.kind.empty()) b.initial.kind = among(c.exact, options::solid_exact_solutions) ? "exact" : "rest";
  complete_sides(c, b);
}

void complete_layer(CaseDescription& c) {
  if (!c.layered() || c.solids.empty() || !c.solids[0].strip()) return;
  const bool line = c.dimension == 1;
  const double half_width = 20 * c.spacing();  // of a line: wide cells, whose width does not count in the time step
  c.layer.along_low = line ? -half_width : c.domain_low[0];
  c.layer.along_high = line ? half_width : c.domain_high[0];
  c.layer.height = c.domain_high[line ? 0 : 1];
}

void check_material(const Node& root, const SolidDescription& b, const std::string& path) {
  const MaterialDescription& m = b.material;
  if (!(m.lambda + m.mu > 0))
    reject(root, path + ".material.lambda",
           path + ".material.lambda = " + shortest(root.find(path + ".material.lambda")->number) +
               " is not allowed: λ + μ must be > 0, so λ > " + shortest(-root.find(path + ".material.mu")->number));
}

void check_dimensions(const Node& root, const CaseDescription& c, const SolidDescription& b, const std::string& path) {
  if (c.dimension == 1 && !b.strip())
    reject(root, path + ".shape", path + ".shape = \"" + b.shape + "\" is not there in 1D: use strip");
  if (c.dimension == 1 && root.find("grid.angle")) reject(root, "grid.angle", "grid.angle is not there in 1D");
  if (b.annulus() && b.inner_radius >= b.outer_radius)
    reject(root, path + ".outer_radius",
           path + ".outer_radius = " + shortest(b.outer_radius) +
               " must be greater than inner_radius = " + shortest(b.inner_radius));
  const double most = std::min(b.size[0], b.size[1]) / 2;
  if ((b.shape == "stick" || b.shape == "rectangle") && b.fillet > most)
    reject(root, path + ".fillet",
           path + ".fillet = " + shortest(b.fillet) + " is not allowed: it must be at most half the shorter side, " +
               shortest(most));
  if (b.shape == "spline" && !(std::ifstream(b.points).peek() != std::ifstream::traits_type::eof()))
    reject(root, path + ".points", path + ".points: the file \"" + b.points + "\" cannot be read");
  for (std::size_t d = 0; b.plate() && d < 2; ++d) {
    if (b.low[d] >= b.high[d])
      reject(root, path + ".high",
             path + ".high must be greater than " + path + ".low along " + (d == 0 ? "x" : "y") + ", not " +
                 shortest(b.high[d]) + " against " + shortest(b.low[d]));
    if (b.hole > 0 && (b.position[d] - b.hole <= b.low[d] || b.position[d] + b.hole >= b.high[d]))
      reject(root, path + ".hole",
             path + ".hole = " + shortest(b.hole) + " around (" + shortest(b.position[0]) + ", " +
                 shortest(b.position[1]) + ") reaches outside the plate");
  }
}

void check_gas(const Node& root, const CaseDescription& c, const SolidDescription& b, const std::string& path) {
  if (const Strings allowed = gas_places_of(b); !among(b.gas, allowed))
    reject(root, path + ".gas",
           path + ".gas = \"" + b.gas + "\" is not there for shape = \"" + b.shape + "\" (allowed: " + joined(allowed) +
               ")");
  if (b.plate() && b.wet() && b.hole == 0)
    reject(root, path, "the key \"" + path + ".hole\" is missing: the radius of the hole that the gas is in");
  if (c.has_gas && !b.wet())
    reject(root, path,
           path + " (" + b.name +
               ") has gas = \"none\", but there is gas in the scene: solids alone are a scene of their own");
  if (b.strip() && !c.layered()) reject(root, "grid", path + " is a strip, which needs grid.kind = \"layer\"");
}

void check_sides(const Node& root, const CaseDescription& c, SolidDescription b, const std::string& path) {
  const Strings own = sides_of(b, c.dimension);
  for (const auto& [key, side] : side_keys(b)) {
    const std::string kind = path + ".sides." + key, traction = path + ".traction." + key;
    for (const std::string& given : {kind, traction})
      if (root.find(given) && !among(key, own))
        reject(root, given,
               given + " is not a side of this solid: " +
                   (own.empty() ? "all of its surface is an interface" : "it has " + joined(own)));
    if (root.find(kind) && root.find(traction))
      reject(root, traction, kind + " and " + traction + " are both given: a side has one or the other");
    if (among(key, own) && side->kind == "exact" && b.initial.kind != "plane_wave" &&
        !among(c.exact, options::solid_exact_solutions))
      reject(root, kind,
             kind + " = \"exact\" needs an exact solution that knows the solid (the key \"exact\": " +
                 joined(options::solid_exact_solutions) + "), or " + path + ".initial.kind = \"plane_wave\"");
  }
  for (const auto& [one, other, key] : {std::tuple{&b.left, &b.right, "left"}, {&b.bottom, &b.top, "bottom"}})
    if (among(key, own) && (one->kind == "periodic") != (other->kind == "periodic"))
      reject(root, path + ".sides", path + ".sides: opposite sides must be periodic both or neither");
  for (const auto& [key, side] : {std::pair{"outer", &b.outer}, {"inner", &b.inner}, {"back", &b.back}})
    if (side->kind == "periodic")
      reject(root, path + ".sides." + key,
             path + ".sides." + key + " = \"periodic\" is not there: it has no opposite side");
  if (b.strip() && c.left == "periodic" && b.left.kind != "periodic")
    reject(root, path + ".sides.left", path + ".sides.left must be periodic like boundaries.left, not " + b.left.kind);
}

void check_initial(const Node& root, const CaseDescription& c, const SolidDescription& b, const std::string& path) {
  const SolidInitialDescription& i = b.initial;
  if (i.kind == "exact" && !among(c.exact, options::solid_exact_solutions))
    reject(root, path + ".initial.kind",
           path + ".initial.kind = \"exact\" needs an exact solution that knows the solid: the key \"exact\", one of " +
               joined(options::solid_exact_solutions));
  if (i.kind == "plane_wave" && i.amplitude >= 1)
    reject(root, path + ".initial.amplitude",
           path + ".initial.amplitude = " + shortest(i.amplitude) + " is not allowed: J = 1 − amplitude would be " +
               shortest(1 - i.amplitude) + " behind the front, it must be > 0");
}

/// One interface belongs to one solid.
void check_shared_interfaces(const Node& root, const CaseDescription& c) {
  const auto encloses = [&](const SolidDescription& b) { return b.wet() && (b.gas == "inside" || b.strip()); };
  for (std::size_t k = 1; k < c.solids.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (c.layered() || (encloses(c.solids[k]) && encloses(c.solids[j])))
        reject(root, "solids." + std::to_string(k),
               "solids." + std::to_string(k) + " (" + c.solids[k].name + ") and solids." + std::to_string(j) + " (" +
                   c.solids[j].name + ") would share one interface with the gas: an interface belongs to one solid");
}

void check_strip_layer(const Node& root, const CaseDescription& c) {
  const std::size_t normal = c.dimension == 1 ? 0 : 1;
  if (!coincide(c.domain_low[normal], 0))
    reject(root, "grid.low",
           "grid.low starts the gas at " + shortest(c.domain_low[normal]) +
               " along the normal, but the wall of solids.0 (" + c.solids[0].name +
               ") is at 0: the boundaries of gas and solid must coincide");
}

void check_ring_layer(const Node& root, const CaseDescription& c) {
  const SolidDescription& b = c.solids[0];
  for (const char* key : {"inner_radius", "outer_radius"})
    if (!root.find(std::string("grid.") + key))
      reject(root, "grid",
             std::string("the key \"grid.") + key + "\" is missing: the " + (key[0] == 'i' ? "inner" : "outer") +
                 " radius of the gas");
  if (c.layer.inner_radius >= c.layer.outer_radius)
    reject(root, "grid.outer_radius",
           "grid.outer_radius = " + shortest(c.layer.outer_radius) +
               " must be greater than grid.inner_radius = " + shortest(c.layer.inner_radius));
  const bool inside = b.gas == "inside";
  const std::string key = inside ? "outer_radius" : "inner_radius", other = inside ? "inner_radius" : "outer_radius";
  const double gas = inside ? c.layer.outer_radius : c.layer.inner_radius;
  const double solid = inside ? b.inner_radius : b.outer_radius;
  if (!coincide(gas, solid))
    reject(root, "grid." + key,
           "grid." + key + " = " + shortest(gas) + " is not solids.0." + other + " = " + shortest(solid) +
               ": the boundaries of gas and solid must coincide");
}

void check_layer(const Node& root, const CaseDescription& c) {
  if (!c.layered()) {
    for (const char* key : {"grid.angle", "grid.inner_radius", "grid.outer_radius"})
      if (root.find(key)) reject(root, key, std::string(key) + " does not belong to grid.kind = \"overlapping\"");
    return;
  }
  if (!c.bodies.empty()) reject(root, "bodies", "bodies cannot be in a scene with grid.kind = \"layer\"");
  if (c.solids.empty() || !(c.solids[0].strip() || (c.solids[0].annulus() && c.solids[0].wet())))
    reject(root, "grid.kind",
           "grid.kind = \"layer\" needs one solid: a strip, or an annulus with gas inside or outside");
  if (c.dimension == 1 && root.find("boundaries.left"))
    reject(root, "boundaries.left", "boundaries.left is not there with grid.kind = \"layer\": it is the interface");
  if (root.find("boundaries.bottom"))
    reject(root, "boundaries.bottom", "boundaries.bottom is not there with grid.kind = \"layer\": it is the interface");
  c.solids[0].strip() ? check_strip_layer(root, c) : check_ring_layer(root, c);
}

/// The background must cover the gas in an annulus or hole.
void check_background(const Node& root, const CaseDescription& c, const SolidDescription& b, const std::string& path) {
  if (c.layered() || b.gas != "inside") return;
  const double radius = b.annulus() ? b.inner_radius : b.hole;
  for (std::size_t d = 0; d < 2; ++d)
    if (b.position[d] - radius < c.domain_low[d] || b.position[d] + radius > c.domain_high[d])
      reject(root, "grid.high",
             "grid.low … grid.high does not contain the gas of radius " + shortest(radius) + " in " + path + " (" +
                 b.name + "): the boundaries of gas and solid must coincide");
}

/// Every picture has something to show.
void check_pictures(const Node& root, const CaseDescription& c) {
  for (const std::string& picture : c.pictures) {
    if (picture == "stress" && c.solids.empty())
      reject(root, "output.pictures", "the picture \"stress\" of output.pictures needs an elastic solid");
    if (!c.has_gas && (picture == "schlieren" || picture == "pressure" || picture == "mach"))
      reject(root, "output.pictures",
             "the picture \"" + picture + "\" of output.pictures needs gas; allowed without: stress, velocity, grids");
  }
}

}  // namespace

void complete_solids(const Node& root, CaseDescription& c) {
  if (c.solids.empty()) return;
  if (c.solid.limiter.empty()) c.solid.limiter = c.limiter == "none" ? "none" : "mc";
  for (std::size_t k = 0; k < c.solids.size(); ++k) complete_solid(root, c, k);
  complete_layer(c);
  c.has_gas = !c.bodies.empty() || std::any_of(c.solids.begin(), c.solids.end(), [](const auto& b) { return b.wet(); });
  if (!c.has_gas && !root.find("output.pictures")) c.pictures = {"stress"};
  if (!root.find("coupling.reference_pressure")) c.coupling.reference_pressure = c.initial.right[3];
}

void check_solids(const Node& root, const CaseDescription& c) {
  for (std::size_t k = 0; k < c.solids.size(); ++k) {
    const SolidDescription& b = c.solids[k];
    const std::string path = "solids." + std::to_string(k);
    check_material(root, b, path);
    check_dimensions(root, c, b, path);
    check_gas(root, c, b, path);
    check_sides(root, c, b, path);
    check_initial(root, c, b, path);
    check_background(root, c, b, path);
  }
  check_layer(root, c);
  check_pictures(root, c);
  check_shared_interfaces(root, c);
  if (c.has_gas && !c.incompressible() && !c.solids.empty() && c.initial.kind != "uniform" && c.initial.kind != "shock" &&
      c.initial.kind != "exact" && !root.find("coupling.reference_pressure"))
    reject(root, "coupling",
           "the key \"coupling.reference_pressure\" is missing: the pressure at which the solid is undeformed");
}

}  // namespace mortise
