// From what a case file says to what a simulation needs: grids, bodies, elastic solids, states, boundaries.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/input/case_description.hpp"
#include "mortise/coupler/simulation.hpp"

namespace mortise {

template <int Dim>
struct Scene {
  SimulationSetup<Dim> setup;
  std::shared_ptr<const ExactSolution<Dim>> exact;  // nullptr: none known
};

/// 1 or 2: the dimension to simulate a case in. Elastic solids on a line are strips four cells wide in the plane.
int scene_dimension(const CaseDescription& description);

/// Throws InputError for everything that needs geometry to be seen: outlines that cross themselves, bodies that overlap, lie
/// outside the domain or closer to each other or to its edge than the overlap resolves, a scheme the scene cannot use.
template <int Dim>
Scene<Dim> build_scene(const CaseDescription& description);

/// Cells along one direction and per tile: about `cells`, in even tiles near `preferred` long.
struct Tiling {
  int cells, tile;
};
Tiling choose_tiling(int cells, int preferred);

/// Key of [boundaries].
BoundaryKind boundary_kind(const std::string& key);

/// An outline that gas flows around, at t = 0.
template <int Dim>
struct PlacedShape {
  std::shared_ptr<const Atlas<Dim>> atlas;  // in the outline's own frame
  std::shared_ptr<const Outline> outline;   // 2D only
  Pose<Dim> pose;
  std::string place, label;  // in the case file; for people: bodies.0 (stick_0)
};

/// Throws InputError for shapes too close to each other or to the edge of the domain (build_scene calls it).
template <int Dim>
void check_clearance(double grid_factor, const EulerSetup<Dim>& fluid, const std::vector<PlacedShape<Dim>>& shapes, double least_gap);

}  // namespace mortise
