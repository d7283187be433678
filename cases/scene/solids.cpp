#include "mortise/cases/scene/solids.hpp"

#include <Eigen/LU>
#include <numbers>

#include "mortise/cases/exact/elastic_cases.hpp"
#include "mortise/cases/scene/bodies.hpp"
#include "mortise/cases/scene/solid_grids.hpp"
#include "mortise/cases/scene/solid_state.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr int solid_layers = 6;    // of the grid beside an interface: interpolation of full order needs 5
constexpr double core_margin = 4;  // cells by which a Cartesian core reaches beyond the outline

/// What the grids of one solid are made from, and what they are made for.
struct Making {
  const CaseDescription& description;
  const SolidDescription& from;
  double spacing;
  ElasticSetup& elastic;
  FittedBody<2>& gas;

  Point<2> center() const { return {from.position[0], from.position[1]}; }
  bool gas_inside() const { return from.gas == "inside"; }
  /// Faces of the gas along an interface where the solid has so many.
  int gas_faces(int faces) const {
    const double ratio = description.coupling.face_ratio;
    return ratio == 1 ? faces : 2 * std::max(2, static_cast<int>(std::lround(0.5 * ratio * faces)));
  }
};

void set_side(const Making& make, Side on, const SideDescription& side) {
  make.elastic.fitted_sides[static_cast<std::size_t>(on)] = elastic_side(side);
}

/// The south side is the interface, or without gas a side like others.
void set_south(const Making& make, const SideDescription& dry) {
  ElasticSide& south = make.elastic.fitted_sides[static_cast<std::size_t>(Side::south)];
  south = make.from.wet() ? ElasticSide{ElasticBoundary::interface, {}} : elastic_side(dry);
}

/// A grid that closes on itself has no ends.
void close_ends(const Making& make) {
  for (const Side side : {Side::west, Side::east})
    make.elastic.fitted_sides[static_cast<std::size_t>(side)] = {ElasticBoundary::periodic, {}};
}

void set_mesh(const Making& make, GrownGrid grid, const std::string& west, const std::string& east,
              const std::string& north) {
  FittedBody<2>& gas = make.gas;
  gas.shape.layers = grid.layers;
  gas.sides = {boundary_kind(west), boundary_kind(east), BoundaryKind::wall, boundary_kind(north)};
  gas.mesh = std::make_shared<GrownGrid>(std::move(grid));
}

void make_strip(const Making& make) {
  const CaseDescription& c = make.description;
  const SolidDescription& b = make.from;
  const bool line = c.dimension == 1, gas_periodic = line || c.left == "periodic";
  const std::string west = gas_periodic ? "periodic" : c.left, east = gas_periodic ? "periodic" : c.right;
  const int faces = line ? 4 : even_cells(c.layer.along_high - c.layer.along_low, make.spacing);
  make.elastic.fitted =
      std::make_shared<GrownGrid>(strip_grid(b, c.layer, -b.thickness, faces, make.spacing, b.left.kind == "periodic"));
  set_south(make, {});
  set_side(make, Side::west, b.right);  // the solid's grid runs against the gas's
  set_side(make, Side::east, b.left);
  set_side(make, Side::north, b.back);
  set_mesh(make, strip_grid(b, c.layer, c.layer.height, make.gas_faces(faces), make.spacing, gas_periodic), west, east,
           line ? c.right : c.top);
}

/// Cells of a Cartesian grid of size about `spacing` that fill a box; tiles of long rows, which the kernels like.
void fill_box(ElasticSetup& elastic, const Box<2>& box, double spacing) {
  static constexpr int preferred[] = {64, 32};
  elastic.domain = box;
  for (int d = 0; d < 2; ++d) {
    const Tiling tiling = choose_tiling(static_cast<int>(std::lround((box.high[d] - box.low[d]) / spacing)), preferred[d]);
    elastic.cells[static_cast<std::size_t>(d)] = tiling.cells;
    elastic.tile[static_cast<std::size_t>(d)] = tiling.tile;
  }
}

/// The gas's grid grown from an outline, over a background.
void grow_gas(const Making& make, const Outline& outline, const Pose<2>& pose) {
  FittedBody<2>& gas = make.gas;
  gas.shape.layers = body_layers(make.from.layers);
  const int faces = make.gas_faces(faces_around(outline.perimeter(), make.spacing));
  gas.shape.atlas = std::make_shared<BodyAtlas>(
      outline_grid(outline, pose, {make.spacing, gas.shape.layers, make.gas_inside()}, faces), make.gas_inside());
}

void make_annulus(const Making& make) {
  const SolidDescription& b = make.from;
  const CaseDescription& c = make.description;
  const bool from_outer = b.gas == "outside";
  const double near = from_outer ? b.outer_radius : b.inner_radius, far = from_outer ? b.inner_radius : b.outer_radius;
  const int faces = faces_around(2 * std::numbers::pi * near, make.spacing);
  make.elastic.fitted = std::make_shared<GrownGrid>(ring_grid(make.center(), near, far, faces, make.spacing));
  close_ends(make);
  set_south(make, b.inner);
  set_side(make, Side::north, from_outer ? b.inner : b.outer);
  if (!b.wet()) return;
  const double end = from_outer ? c.layer.outer_radius : c.layer.inner_radius;
  if (c.layered())
    set_mesh(make, ring_grid(make.center(), near, end, make.gas_faces(faces), make.spacing), "periodic", "periodic",
             c.top);
  else
    grow_gas(make, Outline::circle(near), {make.center(), 0});
}

void make_plate(const Making& make) {
  const SolidDescription& b = make.from;
  ElasticSetup& elastic = make.elastic;
  fill_box(elastic, {{b.low[0], b.low[1]}, {b.high[0], b.high[1]}}, make.spacing);
  elastic.sides = {elastic_side(b.left), elastic_side(b.right), elastic_side(b.bottom), elastic_side(b.top)};
  if (b.hole == 0) return;
  const Outline hole = Outline::circle(b.hole);
  const Pose<2> pose{make.center(), 0};
  auto fitted = std::make_shared<GrownGrid>(outline_grid(hole, pose, {make.spacing, solid_layers, false}));
  elastic.fitted = fitted;
  elastic.atlas = std::make_shared<BodyAtlas>(hole.placed(pose), *fitted);
  elastic.overlap.clip = false;
  close_ends(make);
  set_south(make, b.inner);
  if (b.wet()) grow_gas(make, hole, pose);
}

/// An outline with the solid in it: a Cartesian core and a grid grown inward. Returns the outline in its own frame.
std::shared_ptr<const Outline> make_immersed(const Making& make) {
  const SolidDescription& b = make.from;
  ElasticSetup& elastic = make.elastic;
  const auto outline = std::make_shared<Outline>(outline_of(b).centered());
  const Pose<2> pose = pose_of(b);
  auto fitted = std::make_shared<GrownGrid>(outline_grid(*outline, pose, {make.spacing, solid_layers, true}));
  Box<2> box;
  for (const Point<2>& node : fitted->nodes) box.include(node);
  const double core = fitted->thickness;  // cells of thin bodies are thinner, and their core still needs a few rows
  fill_box(elastic, box.grown(core_margin * core), core);
  elastic.fitted = fitted;
  elastic.atlas = std::make_shared<BodyAtlas>(outline->placed(pose), *fitted, true);
  elastic.overlap = composite_options<2>({elastic.atlas, fitted->thickness, fitted->layers}, core);
  close_ends(make);
  set_south(make, b.outer);
  if (b.wet()) grow_gas(make, *outline, pose);
  return outline;
}

ElasticLimiter limiter_of(const std::string& key) {
  static const Registry<ElasticLimiter> limiters(
      "limiter of solids",
      {{"none", ElasticLimiter::none}, {"minmod", ElasticLimiter::minmod}, {"mc", ElasticLimiter::mc}});
  return limiters.at(key);
}

InterfaceSetup interface_of(const CaseDescription& c, const SolidDescription& b, const FittedBody<2>& gas,
                            const SolidFunction& initial) {
  const CouplingDescription& coupling = c.coupling;
  InterfaceSetup interface;
  interface.name = b.name;
  interface.scheme = c.scheme;
  interface.options.nonlinear = coupling.fsrp == "nonlinear";
  interface.options.reference_load = coupling.load == "reference";
  interface.options.lagged = coupling.wall_velocity == "lagged";
  interface.options.reference_pressure = coupling.reference_pressure + c.p_inf;
  interface.substeps = coupling.substeps;
  interface.inward = b.gas == "inside";
  if (gas.mesh) interface.far.assign(gas.mesh->nodes.end() - gas.mesh->row(), gas.mesh->nodes.end());
  const bool moves = b.velocity != std::array<double, 2>{} || b.angular_velocity != 0;
  if (b.initial.kind != "rest")
    interface.displacement = [initial](const Point<2>& X) { return initial(X, 0).displacement; };
  if (b.initial.kind != "rest" || moves)
    interface.velocity = [initial](const Point<2>& X) { return initial(X, 0).velocity; };
  return interface;
}

/// J > 0 at t = 0 wherever nodes are.
void check_initial(const ElasticSetup& elastic, const SolidFunction& initial) {
  std::vector<Point<2>> places = elastic.fitted ? elastic.fitted->nodes : std::vector<Point<2>>{};
  if (!elastic.atlas)
    for_each_index<2>({0, 0}, {elastic.cells[0], elastic.cells[1]}, [&](const Index<2>& cell) {
      const Point<2> share((cell[0] + 0.5) / elastic.cells[0], (cell[1] + 0.5) / elastic.cells[1]);
      places.emplace_back(elastic.domain.low + share.cwiseProduct(elastic.domain.high - elastic.domain.low));
    });
  for (const Point<2>& X : places) {
    const double j = (Gradient::Identity() + initial(X, 0).gradient).determinant();
    if (!(j > 0))
      throw InputError("initial: J = det(I + ∇u) is " + std::to_string(j) + " at (" + std::to_string(X.x()) + ", " +
                       std::to_string(X.y()) + ") at t = 0: it must be > 0 everywhere in the solid");
  }
}

/// The gas's grid must not fold when its interface is where the solid is at t = 0.
void check_displaced(const FittedBody<2>& gas, const InterfaceSetup& interface) {
  if (!interface.displacement) return;
  const GrownGrid& grid = gas.mesh ? *gas.mesh : gas.shape.atlas->grid();
  std::vector<Point<2>> curve(grid.nodes.begin(), grid.nodes.begin() + grid.row());
  for (Point<2>& node : curve) node += interface.displacement(node);
  try {
    if (gas.mesh)
      stretch_between(curve, interface.far, grid.layers, grid.spacing, grid.periodic, grid.period);
    else
      grow_from(curve, {grid.spacing, grid.layers, interface.inward, grid.thickness}, grid.smoothing);
  } catch (const NumericalError& error) {
    throw InputError(std::string("initial: the displacement at t = 0 folds the gas's grid: ") + error.what());
  }
}

}  // namespace

void add_solid(const CaseDescription& description, std::size_t index, double spacing,
               const std::shared_ptr<const ExactSolution<2>>& exact, SimulationSetup<2>& setup,
               std::vector<PlacedShape<2>>& shapes) {
  const SolidDescription& from = description.solids[index];
  const Material material = material_of(from);
  const SolidFunction initial = solid_function(from, material, exact);
  SolidSetup solid;
  FittedBody<2> gas;
  solid.elastic.name = from.name;
  gas.name = from.name + "_gas";
  gas.shape.spacing = spacing;
  solid.elastic.options = {material, limiter_of(description.solid.limiter), description.solid.null_mode_upwinding};
  solid.elastic.skip = description.skip;
  solid.elastic.smooth = exact && exact->smooth();
  solid.initial = [initial, law = material.law](const Point<2>& X, double) {
    return elastic_state(law, initial(X, 0));
  };
  solid.elastic.exact = [initial, law = material.law](const Point<2>& X, double t) {
    return elastic_state(law, initial(X, t));
  };
  const Making make{description, from, spacing, solid.elastic, gas};
  const std::string label = "solids." + std::to_string(index) + " (" + from.name + ")";
  std::shared_ptr<const Outline> outline;
  try {
    if (from.strip())
      make_strip(make);
    else if (from.annulus())
      make_annulus(make);
    else if (from.plate())
      make_plate(make);
    else
      outline = make_immersed(make);
    check_initial(solid.elastic, initial);
    if (from.wet()) {
      solid.interface = interface_of(description, from, gas, initial);
      check_displaced(gas, *solid.interface);
    }
  } catch (const InputError& error) {
    throw InputError(from.place + ": " + label + ": " + error.what());
  }
  if (from.wet()) {
    solid.interface->body = setup.fluid.bodies.size();
    setup.fluid.bodies.push_back(std::move(gas));
  }
  if (from.wet() && outline) {
    const auto atlas = std::make_shared<BodyAtlas>(*outline, grow(*outline, {spacing, body_layers(from.layers)}));
    shapes.push_back({atlas, outline, pose_of(from), from.place, label});
  }
  setup.solids.push_back(std::move(solid));
}

Box<2> bounds_of(const SimulationSetup<2>& setup) {
  Box<2> box;
  for (const FittedBody<2>& gas : setup.fluid.bodies)
    if (gas.mesh)
      for (const Point<2>& node : gas.mesh->nodes) box.include(node);
  for (const SolidSetup& solid : setup.solids) {
    if (solid.elastic.fitted)
      for (const Point<2>& node : solid.elastic.fitted->nodes) box.include(node);
    if (solid.elastic.cells[0] > 0 && !solid.elastic.atlas) {
      box.include(solid.elastic.domain.low);
      box.include(solid.elastic.domain.high);
    }
  }
  return box;
}

}  // namespace mortise
