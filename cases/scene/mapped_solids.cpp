#include "mortise/cases/scene/mapped_solids.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "mortise/cases/exact/elastic_cases.hpp"
#include "mortise/cases/scene/bodies.hpp"
#include "mortise/cases/scene/solid_grids.hpp"
#include "mortise/cases/scene/solid_state.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Cells around the outline in which the level set is tabulated: as far as a blur zone reaches in material that is
/// compressed by half, and a little more.
double band(const CaseDescription& description) { return 2 * description.coupling.blur + 3; }

}  // namespace

Point<2> reference_point(const SolidFunction& initial, const Point<2>& x) {
  Point<2> X = x;
  for (int k = 0; k < 40; ++k) {
    const ExactSolid at = initial(X, 0);
    const Point<2> rest = X + at.displacement - x;
    if (!(rest.squaredNorm() < 1e200)) break;
    const Point<2> step = (Gradient::Identity() + at.gradient).inverse() * rest;
    X -= step;
    if (step.norm() <= 1e-13 * (1 + X.norm())) return X;
  }
  return Point<2>::Constant(std::numeric_limits<double>::quiet_NaN());
}

std::shared_ptr<const LevelSet> level_set_of(const CaseDescription& description, const SolidDescription& from,
                                             double spacing) {
  const auto level_set = std::make_shared<LevelSet>(outline_of(from).centered().placed(pose_of(from)), 0.5 * spacing,
                                                    band(description) * spacing);
  double deepest = 0;
  const Box<2> box = level_set->box();
  for (double y = box.low.y(); y < box.high.y(); y += 0.5 * spacing)
    for (double x = box.low.x(); x < box.high.x(); x += 0.5 * spacing) deepest = std::min(deepest, (*level_set)(x, y));
  if (-deepest < description.coupling.blur * spacing)
    throw InputError("the blur zone, " + std::to_string(description.coupling.blur) +
                     " cells to each side, is wider than the solid, of which no point is farther than " +
                     std::to_string(-deepest / spacing) +
                     " cells from its surface: use a larger grid.factor or a smaller coupling.blur");
  return level_set;
}

void refuse_what_cannot_be_mapped(const CaseDescription& description, const SolidDescription& from) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(from.place + ": scheme = \"reference-map\" " + what);
  };
  if (!from.immersed() || from.gas == "inside")
    refuse("takes solids that are surrounded by gas, and " + from.name + " is not: use projection");
  if (!from.wet()) refuse("has gas around every solid, and " + from.name + " has none");
  if (!description.bodies.empty())
    refuse("moves elastic solids only, and the case has rigid bodies, too: use projection");
  if (description.riemann != "hllc") refuse("needs fluid.riemann = \"hllc\"");
}

void add_mapped_solid(const CaseDescription& description, std::size_t index, double spacing,
                      const std::shared_ptr<const ExactSolution<2>>& exact, SimulationSetup<2>& setup,
                      std::vector<PlacedShape<2>>& shapes) {
  const SolidDescription& from = description.solids[index];
  refuse_what_cannot_be_mapped(description, from);
  if (!setup.reference_map) {
    setup.reference_map.emplace();
    setup.reference_map->blur = description.coupling.blur * spacing;
    setup.reference_map->pressure = description.coupling.reference_pressure + description.p_inf;
  }
  const Material material = material_of(from);
  const SolidFunction initial = solid_function(from, material, exact);
  const std::string label = "solids." + std::to_string(index) + " (" + from.name + ")";
  try {
    const auto outline = std::make_shared<Outline>(outline_of(from).centered());
    const Pose<2> pose = pose_of(from);
    const auto level_set = level_set_of(description, from, spacing);
    const auto atlas = std::make_shared<BodyAtlas>(*outline, grow(*outline, {spacing, body_layers(from.layers)}));
    shapes.push_back({atlas, outline, pose, from.place, label});
    setup.reference_map->bodies.push_back(
        {.name = from.name,
         .material = material,
         .level_set = level_set,
         .reference = [initial](const Point<2>& x) { return reference_point(initial, x); },
         .velocity = [initial](const Point<2>& X) { return initial(X, 0).velocity; }});
  } catch (const InputError& error) {
    throw InputError(from.place + ": " + label + ": " + error.what());
  }
}

}  // namespace mortise
