#include "mortise/cases/pictures/axes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace mortise {

std::vector<Point<2>> Axes::pixels(const std::vector<Point<2>>& points) const {
  std::vector<Point<2>> result;
  result.reserve(points.size());
  for (const Point<2>& point : points) result.push_back(pixel(point));
  return result;
}

std::vector<Tick> ticks(double low, double high, int count) {
  const double rough = (high - low) / count;
  if (!(rough > 0) || !std::isfinite(rough)) return {};
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double lead = rough / decade;
  const double step = decade * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
  const double largest = std::max(std::fabs(low), std::fabs(high));
  if (step < 1e-14 * largest) return {};  // multiples of the step would not differ
  const int decimals = static_cast<int>(-std::floor(std::log10(step) + 1e-9));
  const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(largest / step))) + 1, 1, 17);
  const bool plain = decimals <= 4 && largest < 1e5;
  std::vector<Tick> result;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    const double value = k == 0 ? 0.0 : k * step;
    result.push_back({value, plain ? fixed(value, std::max(decimals, 0)) : label(value, digits)});
  }
  return result;
}

std::string label(double value, int digits) {
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string fixed(double value, int decimals) {
  std::array<char, 400> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
  return {text.data(), end.ptr};
}

void draw_label(Image& image, double x, double y, const std::string& text, double size, double room, Align align) {
  draw_text(image, x, y, text, size * std::min(1.0, room / std::max(text_width(text, size), 1e-9)), ink::text, align);
}

void draw_axes(Image& image, const Axes& axes, double unit, bool label_x) {
  const double left = axes.x0, right = axes.x1, top = axes.y0, bottom = axes.y1, mark = 6 * unit, size = 11 * unit;
  image.draw_polyline({{left, top}, {right, top}, {right, bottom}, {left, bottom}}, 1.2 * unit, ink::frame, true);
  for (const auto& [x, text] : ticks(axes.window.low.x(), axes.window.high.x(), 9)) {
    const double at = axes.pixel({x, axes.window.low.y()}).x();
    image.draw_polyline({{at, bottom}, {at, bottom + mark}}, 1.2 * unit, ink::frame);
    if (label_x) draw_text(image, at, bottom + mark + 1.6 * size, text, size, ink::text, Align::center);
  }
  for (const auto& [y, text] :
       ticks(axes.window.low.y(), axes.window.high.y(), std::max(2, static_cast<int>((bottom - top) / (70 * unit))))) {
    const double at = axes.pixel({axes.window.low.x(), y}).y();
    image.draw_polyline({{left - mark, at}, {left, at}}, 1.2 * unit, ink::frame);
    draw_label(image, left - 1.8 * mark, at + 0.5 * size, text, size, 52 * unit, Align::right);
  }
}

}  // namespace mortise
