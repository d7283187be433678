// Colour maps of 256 entries, built in Oklab (B. Ottosson, 2020) so that equal steps of the value are equal steps of
// lightness: readable in print and by colour-blind readers.
#pragma once

#include <array>

#include "mortise/grids/output/image.hpp"

namespace mortise {

using ColorMap = std::array<Rgb, 256>;

/// Dark violet over teal to light yellow, lightness rising linearly.
const ColorMap& sequential_map();
/// Blue over near-white to red, symmetric in lightness; for values of both signs.
const ColorMap& diverging_map();
/// Pale yellow over orange to dark red: for solids beside a fluid in other colours.
const ColorMap& stress_map();
/// Black to white.
const ColorMap& grey_map();

/// The entry for s ∈ [0, 1]; outside: the nearest end.
inline Rgb color_at(const ColorMap& map, double s) {
  return map[static_cast<std::size_t>(s > 0 ? (s < 1 ? 255 * s + 0.5 : 255.0) : 0.0)];
}

}  // namespace mortise
