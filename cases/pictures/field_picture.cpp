#include <algorithm>
#include <cmath>

#include "mortise/cases/pictures/colormap.hpp"
#include "mortise/cases/pictures/field_raster.hpp"
#include "mortise/cases/pictures/picture_kinds.hpp"
#include "mortise/cases/pictures/picture_values.hpp"

namespace mortise {
namespace {

constexpr double schlieren_strength = 5;  // k in exp(−k |∇ρ|/range)
constexpr double body_grid_priority = 4;  // against 1 of the background, where both have active cells

/// Vertical bar with round ticks between the two ends, which are labelled exactly.
void draw_bar(Image& image, const Axes& axes, const ColorMap& map, double low, double high, double unit) {
  const int x0 = axes.x1 + static_cast<int>(std::lround(16 * unit)),
            x1 = x0 + std::max(4, static_cast<int>(std::lround(18 * unit)));
  const Axes bar{x0, axes.y0, x1, axes.y1, {{0, low}, {1, high > low ? high : low + 1}}};
  for (int y = bar.y0; y < bar.y1; ++y)
    for (int x = x0; x < x1; ++x) image.at(x, y) = color_at(map, (bar.y1 - y - 0.5) / (bar.y1 - bar.y0));
  const double left = x0, right = x1, top = bar.y0, bottom = bar.y1, size = 11 * unit;
  image.draw_polyline({{left, top}, {right, top}, {right, bottom}, {left, bottom}}, 1.2 * unit, ink::frame, true);
  const auto mark = [&](double value, const std::string& text) {
    const double y = bar.pixel({0, value}).y();
    image.draw_polyline({{right, y}, {right + 5 * unit, y}}, 1.2 * unit, ink::frame);
    draw_label(image, right + 9 * unit, std::clamp(y + 0.5 * size, top + size, bottom), text, size,
               image.width() - right - 14 * unit, Align::left);
  };
  mark(low, label(low));
  if (!(high > low)) return;
  mark(high, label(high));
  for (const auto& [value, text] : ticks(low, high, 6))
    if (std::min(bar.pixel({0, value}).y() - top, bottom - bar.pixel({0, value}).y()) > 2.2 * size) mark(value, text);
}

}  // namespace

void draw_field(Image& image, const Axes& axes, const Snapshot& snapshot, const RenderOptions& options, double unit) {
  const PictureValues values = picture_values(snapshot, options.field);
  auto [low, high] = options.range ? *options.range : value_range(snapshot, values, options.field);
  const bool schlieren = options.field == "schlieren", signs = !options.range && low < 0 && high > 0;
  if (signs) {
    high = std::max(high, -low);
    low = -high;
  }
  const ColorMap& map = schlieren                            ? grey_map()
                        : signs || (low < 0 && low == -high) ? diverging_map()
                                                             : sequential_map();
  FieldRaster raster(axes);
  for (std::size_t k = 0; k < snapshot.grids.size(); ++k)
    raster.add(snapshot.grids[k], values[k], k == 0 ? 1 : body_grid_priority);
  const double scale = high > low ? 1 / (high - low) : 0;
  for (int y = axes.y0; y < axes.y1; ++y)
    for (int x = axes.x0; x < axes.x1; ++x) {
      const double value = raster.at(x - axes.x0, y - axes.y0);
      if (std::isnan(value)) continue;
      const double s = (value - low) * scale;
      image.at(x, y) = color_at(map, schlieren ? std::exp(-schlieren_strength * s) : s);
    }
  if (schlieren) return;
  image.clip_to_all();
  draw_bar(image, axes, map, low, high, unit);
}

}  // namespace mortise
