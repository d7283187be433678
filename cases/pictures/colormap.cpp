#include "mortise/cases/pictures/colormap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mortise {
namespace {

/// Linear light to the 8-bit sRGB transfer curve; out-of-range values are clipped.
std::uint8_t encoded(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return static_cast<std::uint8_t>(
      std::lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
}

/// Oklab lightness (0 … 1), chroma and hue (degrees) → sRGB.
Rgb from_oklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(hue * std::numbers::pi / 180), b = chroma * std::sin(hue * std::numbers::pi / 180);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

template <class Color>
ColorMap tabulated(Color color) {
  ColorMap map;
  for (std::size_t k = 0; k < map.size(); ++k) map[k] = color(static_cast<double>(k) / 255);
  return map;
}

}  // namespace

const ColorMap& sequential_map() {
  static const ColorMap map = tabulated([](double s) {
    const double hue = 310 - 200 * s + 20 * s * (1 - s) * (1 - 2 * s);  // violet, blue, teal, green, yellow
    const double chroma = 0.094 + 0.095 * s * s * s * s;                // inside the sRGB gamut all along
    return from_oklch(0.22 + 0.72 * s, chroma, hue);
  });
  return map;
}

const ColorMap& diverging_map() {
  static const ColorMap map = tabulated([](double s) {
    const double away = std::fabs(2 * s - 1);
    return from_oklch(0.97 - 0.52 * away, 0.34 * away * (1 - 0.58 * away), s < 0.5 ? 255 : 28);
  });
  return map;
}

const ColorMap& stress_map() {
  static const ColorMap map =
      tabulated([](double s) { return from_oklch(0.96 - 0.66 * s, 0.05 + 0.4 * s * (1 - 0.8 * s), 95 - 75 * s); });
  return map;
}

const ColorMap& grey_map() {
  static const ColorMap map = tabulated([](double s) {
    const auto grey = static_cast<std::uint8_t>(std::lround(255 * s));
    return Rgb{grey, grey, grey};
  });
  return map;
}

}  // namespace mortise
