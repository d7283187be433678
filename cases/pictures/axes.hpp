// Plot frames: the map from physical to pixel coordinates, ticks and labels.
#pragma once

#include <string>
#include <vector>

#include "mortise/grids/output/image.hpp"

namespace mortise {

/// Colours shared by all pictures.
namespace ink {
inline constexpr Rgb text{38, 42, 48}, frame{90, 96, 104}, rule{226, 229, 233}, body{186, 192, 199}, edge{36, 40, 47};
}

/// A rectangle of pixels that shows a box of physical space, y upwards.
struct Axes {
  int x0, y0, x1, y1;  // pixels: x0 ≤ x < x1, y0 ≤ y < y1
  Box<2> window;       // physical

  double scale_x() const { return (x1 - x0) / (window.high.x() - window.low.x()); }  // pixels per unit of length
  double scale_y() const { return (y1 - y0) / (window.high.y() - window.low.y()); }
  Point<2> pixel(const Point<2>& p) const {
    return {x0 + (p.x() - window.low.x()) * scale_x(), y1 - (p.y() - window.low.y()) * scale_y()};
  }
  std::vector<Point<2>> pixels(const std::vector<Point<2>>& points) const;
};

/// A place along an axis and what is written there.
struct Tick {
  double value;
  std::string label;
};

/// Round numbers (1, 2 or 5 times a power of ten apart) in [low, high], about `count` of them, equally many decimals.
std::vector<Tick> ticks(double low, double high, int count);

/// A number for a label, in at most that many significant digits, without trailing zeros.
std::string label(double value, int digits = 4);
/// With exactly that many decimals.
std::string fixed(double value, int decimals);

/// draw_text, made smaller if it is wider than `room` pixels.
void draw_label(Image& image, double x, double y, const std::string& text, double size, double room, Align align);

/// Frame, tick marks and tick labels; `unit` is the pixel size of a hair line at this picture width.
void draw_axes(Image& image, const Axes& axes, double unit, bool label_x = true);

}  // namespace mortise
