#include <algorithm>
#include <cmath>
#include <fstream>
#include <string_view>

#include "mortise/cases/input/case_checks.hpp"
#include "mortise/cases/input/expression.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

/// One degree of freedom of a body and the keys that speak about it.
struct Freedom {
  std::string name;           // x, y, angle
  std::string motion, force;  // formulas
  std::string force_key;
  double speed;  // at t = 0
  std::string speed_key;
  bool fixed;

  bool free() const { return !fixed && motion.empty(); }
};

std::vector<Freedom> freedoms(const BodyDescription& b, int dimension) {
  const auto fixed = [&](const char* name) { return std::find(b.fixed.begin(), b.fixed.end(), name) != b.fixed.end(); };
  std::vector<Freedom> all = {{"x", b.motion_x, b.force_x, "force.x", b.velocity[0], "velocity", fixed("x")}};
  if (dimension == 1) return all;
  all.push_back({"y", b.motion_y, b.force_y, "force.y", b.velocity[1], "velocity", fixed("y")});
  all.push_back(
      {"angle", b.motion_angle, b.torque, "force.torque", b.angular_velocity, "angular_velocity", fixed("angle")});
  return all;
}

void check_dimension(const Node& root, const BodyDescription& b, const std::string& path, int dimension) {
  const bool line_shape = b.shape == "slab" || b.shape == "half_space";
  if (line_shape != (dimension == 1))
    reject(root, path + ".shape",
           path + ".shape = \"" + b.shape + "\" is not there in " + std::to_string(dimension) + "D: use " +
               (line_shape ? "circle, ellipse, stick, rectangle, polygon or spline" : "slab or half_space"));
  if (dimension == 2) return;
  for (const char* key :
       {"angle", "angular_velocity", "inertia", "motion.y", "motion.angle", "force.y", "force.torque"})
    if (root.find(path + "." + key)) reject(root, path + "." + key, path + "." + key + " is not there in 1D");
  for (const std::string& name : b.fixed)
    if (name != "x") reject(root, path + ".fixed", path + ".fixed must be [\"x\"] in 1D, not \"" + name + "\"");
}

void check_half_space(const Node& root, const CaseDescription& c, const BodyDescription& b, const std::string& path) {
  if (b.shape == "half_space" && c.left == "periodic")
    reject(root, path + ".shape",
           path + ".shape = \"half_space\" cannot be in a periodic domain, where it would be everywhere: use slab, or other "
                  "boundaries");
}

void check_freedom(const Node& root, const Freedom& f, const std::string& path) {
  const std::string motion = path + ".motion." + f.name;
  if (f.fixed && !f.motion.empty())
    reject(root, motion, motion + " moves what " + path + ".fixed holds: give one or the other");
  const std::string held = f.fixed ? "is fixed" : "has a prescribed motion";
  if (!f.free() && f.speed != 0)
    reject(root, path + "." + f.speed_key, path + "." + f.speed_key + " has no effect: " + f.name + " " + held);
  if (!f.free() && !f.force.empty())
    reject(root, path + "." + f.force_key, path + "." + f.force_key + " has no effect: " + f.name + " " + held);
  if (!f.motion.empty()) {
    const double start = Expression(f.motion, {"t"})(0.0);
    if (!(std::abs(start) <= 1e-12))
      reject(root, motion, motion + " must be 0 at t = 0, as a displacement from there, not " + shortest(start));
  }
  if (!f.force.empty() && !std::isfinite(Expression(f.force, {"t"})(0.0)))
    reject(root, path + "." + f.force_key, path + "." + f.force_key + " = \"" + f.force + "\" is not finite at t = 0");
}

void check_mass(const Node& root, const BodyDescription& b, const std::string& path, const std::vector<Freedom>& all) {
  bool moves = false, turns = false;
  for (const Freedom& f : all) (f.name == "angle" ? turns : moves) |= f.free();
  if (b.shape == "half_space" && b.density)
    reject(root, path + ".density", path + ".density cannot be used, a half space has no volume: give mass instead");
  if (moves && !b.density && !b.mass)
    reject(root, path,
           "the key \"" + path + (b.shape == "half_space" ? ".mass" : ".density") + "\" is missing: " +
               (b.shape == "half_space" ? "the mass per unit area" : "a number ≥ 0 (or mass and inertia)") +
               " of a body that moves freely");
  if (turns && !b.density && !b.inertia)
    reject(root, path,
           "the key \"" + path + ".inertia\" is missing: a number ≥ 0 (or density) of a body that turns freely");
}

void check_scheme(const Node& root, const CaseDescription& c, const BodyDescription& b, const std::string& path,
                  const std::vector<Freedom>& all) {
  if (c.scheme != "traditional") return;
  for (const Freedom& f : all) {
    const bool turn = f.name == "angle";
    const double weight = b.density ? *b.density : (turn ? b.inertia : b.mass).value_or(1);
    if (!f.free() || weight > 0) continue;
    const std::string what = b.density ? "density" : turn ? "inertia" : "mass";
    reject(root, "scheme",
           "scheme = \"traditional\" cannot move " + path + ", whose " + what +
               " is 0, as it divides by it: use rigid, or give it " + what);
  }
}

void check_shape(const Node& root, const BodyDescription& b, const std::string& path) {
  const bool rounded_box = b.shape == "stick" || b.shape == "rectangle";
  const double most = std::min(b.size[0], b.size[1]) / 2;
  if (rounded_box && b.fillet > most)
    reject(root, path + ".fillet",
           path + ".fillet = " + shortest(b.fillet) + " is not allowed: it must be at most half the shorter side, " +
               shortest(most));
  if (b.shape == "spline" && !(std::ifstream(b.points).peek() != std::ifstream::traits_type::eof()))
    reject(root, path + ".points", path + ".points: the file \"" + b.points + "\" cannot be read");
}

}  // namespace

void check_body(const Node& root, const CaseDescription& c, std::size_t index) {
  const BodyDescription& b = c.bodies[index];
  const std::string path = "bodies." + std::to_string(index);
  check_dimension(root, b, path, c.dimension);
  check_half_space(root, c, b, path);
  check_shape(root, b, path);
  const std::vector<Freedom> all = freedoms(b, c.dimension);
  for (const Freedom& f : all) check_freedom(root, f, path);
  check_mass(root, b, path, all);
  check_scheme(root, c, b, path, all);
  if (b.surface == "exact" && c.exact.empty())
    reject(root, path + ".surface",
           path + ".surface = \"exact\" needs an exact solution: the key \"exact\" is missing");
  if (b.surface == "exact" && std::any_of(all.begin(), all.end(), [](const Freedom& f) { return f.free(); }))
    reject(root, path + ".surface",
           path + ".surface = \"exact\" feels no force: prescribe the motion of the body, or fix it");
}

}  // namespace mortise
