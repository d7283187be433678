// Gaps between bodies, and between bodies and the edge of the domain.
#pragma once

#include <memory>
#include <vector>

#include "mortise/coupler/contact.hpp"
#include "mortise/grids/geometry/line_atlas.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

/// A body as gaps see it.
template <int Dim>
struct GapBody {
  const Atlas<Dim>* atlas = nullptr;
  const Outline* outline = nullptr;  // 2D only
  Pose<Dim> pose;
};

/// The outline is a circle about its centroid.
bool is_round(const Outline& outline);

/// Closest points of all pairs of bodies, and of bodies and sides of the domain, that are closer than `within`. Sides of
/// periodic directions do not count. Only pairs whose bounding boxes are that close are looked at.
template <int Dim>
std::vector<ContactPoint<Dim>> find_gaps(const std::vector<GapBody<Dim>>& bodies, const Box<Dim>& domain, const std::array<bool, Dim>& periodic,
                                         double within);

}  // namespace mortise
