// Undeformed grids at interfaces, in space. Every grid lies on the left of its layer 0, so the solid's and the gas's
// run along the interface in opposite directions; with equally many faces they have the same nodes there.
#pragma once

#include "mortise/cases/input/case_description.hpp"
#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

/// An even number of cells of about `spacing` along a length, at least 4.
int even_cells(double length, double spacing);
/// The number of faces grow() gives a closed curve: the multiple of 4 nearest to length/spacing, at least 16.
int faces_around(double length, double spacing);

/// From the wall of a strip to a straight line at `height` along the wall's normal (negative: into the solid).
/// Throws InputError when the wall crosses that line.
GrownGrid strip_grid(const SolidDescription& strip, const LayerDescription& frame, double height, int faces,
                     double spacing, bool periodic);

/// From one circle around `center` to another, which may be smaller. Node 0 is on the right.
GrownGrid ring_grid(const Point<2>& center, double from_radius, double to_radius, int faces, double spacing);

/// Grown from an outline in its own frame and put at a pose; `faces` 0: faces_around() of them.
GrownGrid outline_grid(const Outline& outline, const Pose<2>& pose, const GrowthOptions& options, int faces = 0);

}  // namespace mortise
