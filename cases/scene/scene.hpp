// From what a case file says to what a simulation needs: grids, bodies, states, boundaries.
#pragma once

#include <memory>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/input/case_description.hpp"
#include "mortise/coupler/simulation.hpp"

namespace mortise {

template <int Dim>
struct Scene {
  SimulationSetup<Dim> setup;
  std::shared_ptr<const ExactSolution<Dim>> exact;  // nullptr: none known
};

/// Throws InputError for everything that needs geometry to be seen: outlines that cross themselves, bodies that overlap, lie
/// outside the domain or closer to each other or to its edge than the overlap resolves, a scheme the scene cannot use.
template <int Dim>
Scene<Dim> build_scene(const CaseDescription& description);

/// Cells along one direction and per tile: about `cells`, in even tiles near `preferred` long.
struct Tiling {
  int cells, tile;
};
Tiling choose_tiling(int cells, int preferred);

/// Throws InputError for bodies too close to each other or to the edge of the domain (build_scene calls it).
template <int Dim>
void check_clearance(const CaseDescription& description, const SimulationSetup<Dim>& setup, double least_gap);

}  // namespace mortise
