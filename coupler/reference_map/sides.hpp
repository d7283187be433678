// What lies at the four sides of a rectangular incompressible flow.
#pragma once

#include <array>
#include <functional>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// periodic: joined to the opposite side (both must be); wall: the fluid sticks to it; slip_wall: no normal velocity,
/// no shear stress; inflow: the velocity is given; outflow: p = 0 and ∂v/∂n = 0.
enum class SideKind { periodic, wall, slip_wall, inflow, outflow };

/// One side of the domain.
struct FlowSide {
  SideKind kind = SideKind::periodic;
  double speed = 0;                                           // wall: its own velocity along +x or +y
  std::function<Point<2>(const Point<2>& place)> velocity{};  // inflow: at a point of the side, constant in time
};

/// Numbers of the sides in arrays of four.
enum SideNumber : std::size_t { west = 0, east = 1, south = 2, north = 3 };

using FlowSides = std::array<FlowSide, 4>;  // by SideNumber

/// The velocity is known at the side (wall, inflow).
inline bool velocity_given(SideKind kind) { return kind == SideKind::wall || kind == SideKind::inflow; }
/// The normal velocity is known at the side, so that the pressure satisfies a Neumann condition there.
inline bool normal_velocity_given(SideKind kind) { return velocity_given(kind) || kind == SideKind::slip_wall; }

}  // namespace mortise
