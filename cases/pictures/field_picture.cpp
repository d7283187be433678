#include <algorithm>
#include <cmath>
#include <optional>

#include "mortise/cases/pictures/colormap.hpp"
#include "mortise/cases/pictures/field_raster.hpp"
#include "mortise/cases/pictures/picture_kinds.hpp"
#include "mortise/cases/pictures/picture_values.hpp"

namespace mortise {
namespace {

constexpr double schlieren_strength = 5;  // k in exp(−k |∇ρ|/range)
constexpr double body_grid_priority = 4;  // against 1 of the background, where both have active cells
constexpr double faint = 0.35;            // of schlieren that are no more than a setting for stresses
constexpr double no_stress = 1e-10;       // what is below is round-off, not worth colours

/// One scalar on all grids and how it is coloured.
struct Layer {
  PictureValues values;
  double low, high;  // at the ends of the map
  const ColorMap* map;
  bool schlieren = false;
  double strength = 1;  // less than 1: paler

  Rgb color(double value) const {
    const double s = high > low ? (value - low) / (high - low) : 0;
    return blend(white, color_at(*map, schlieren ? std::exp(-schlieren_strength * s) : s), strength);
  }
};

/// The field of that name, symmetric about zero if it has both signs and no range was asked for.
Layer field_layer(const Snapshot& snapshot, const std::string& field,
                  const std::optional<std::array<double, 2>>& asked) {
  PictureValues values = picture_values(snapshot, field);
  auto [low, high] = asked ? *asked : value_range(snapshot, values, field);
  const bool schlieren = field == "schlieren", signs = !asked && low < 0 && high > 0;
  if (signs) {
    high = std::max(high, -low);
    low = -high;
  }
  const ColorMap& map = schlieren                            ? grey_map()
                        : signs || (low < 0 && low == -high) ? diverging_map()
                                                             : sequential_map();
  return {std::move(values), low, high, &map, schlieren};
}

Layer stress_layer(const Snapshot& snapshot, const std::optional<std::array<double, 2>>& asked) {
  Layer layer{picture_values(snapshot, "stress"), 0, 0, &stress_map()};
  layer.high = std::max(value_range(snapshot, layer.values, "stress")[1], no_stress);
  if (asked) layer.low = (*asked)[0], layer.high = (*asked)[1];
  return layer;
}

bool holds_data(const Snapshot& snapshot, const PictureValues& values, bool solid) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (snapshot.grids[k].solid == solid)
      for (const double value : values[k])
        if (std::isfinite(value)) return true;
  return false;
}

/// Which pixels of the axes lie in solids that share the grid of the fluid. Empty without such solids.
std::vector<char> inside_surfaces(const Axes& axes, const Snapshot& snapshot) {
  if (snapshot.surfaces.empty()) return {};
  std::vector<char> inside(static_cast<std::size_t>((axes.x1 - axes.x0) * (axes.y1 - axes.y0)), 0);
  for (const std::vector<Point<2>>& surface : snapshot.surfaces)  // those of holes are surfaces, too
    for_each_run(axes.pixels(surface), {axes.x0, axes.y0, axes.x1, axes.y1}, [&](int y, int x0, int x1) {
      for (int x = x0; x < x1; ++x)
        inside[static_cast<std::size_t>((y - axes.y0) * (axes.x1 - axes.x0) + x - axes.x0)] ^= 1;
    });
  return inside;
}

constexpr int layers_continued = 4;  // cells that are partly solid hold no gas, beside cells that are wholly gas

/// Values of cells without data beside others: the means of those of their neighbours, layer by layer.
std::vector<double> continued(const GridSnapshot& grid, std::vector<double> values) {
  for (int layer = 0; layer < layers_continued; ++layer) {
    const std::vector<double> before = values;
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int i = 0; i < grid.cells[0]; ++i) {
        if (std::isfinite(before[grid.cell(i, j)])) continue;
        double sum = 0;
        int count = 0;
        for (int b = std::max(j - 1, 0); b <= std::min(j + 1, grid.cells[1] - 1); ++b)
          for (int a = std::max(i - 1, 0); a <= std::min(i + 1, grid.cells[0] - 1); ++a)
            if (std::isfinite(before[grid.cell(a, b)])) sum += before[grid.cell(a, b)], ++count;
        if (count > 0) values[grid.cell(i, j)] = sum / count;
      }
  }
  return values;
}

/// Colours what the grids of one domain cover and have values on; of solids and fluid on one grid up to the surfaces
/// between them, not by whole cells.
void paint(Image& image, const Axes& axes, const Snapshot& snapshot, const Layer& layer, bool solid) {
  const std::vector<char> inside = inside_surfaces(axes, snapshot);
  const bool shared = !inside.empty();
  FieldRaster raster(axes);
  for (std::size_t k = 0; k < snapshot.grids.size(); ++k)
    if (snapshot.grids[k].solid == solid)
      raster.add(snapshot.grids[k], shared ? continued(snapshot.grids[k], layer.values[k]) : layer.values[k],
                 k == 0 || solid ? 1 : body_grid_priority, shared);
  std::size_t pixel = 0;
  for (int y = axes.y0; y < axes.y1; ++y)
    for (int x = axes.x0; x < axes.x1; ++x, ++pixel) {
      const double value = raster.at(x - axes.x0, y - axes.y0);
      if (!std::isnan(value) && (!shared || (inside[pixel] != 0) == solid)) image.at(x, y) = layer.color(value);
    }
}

/// Vertical bar from y0 to y1 with round ticks between the two ends, which are labelled exactly.
void draw_bar(Image& image, const Axes& axes, int y0, int y1, const Layer& layer, double unit) {
  const double low = layer.low, high = layer.high;
  const int x0 = axes.x1 + static_cast<int>(std::lround(16 * unit)),
            x1 = x0 + std::max(4, static_cast<int>(std::lround(18 * unit)));
  const Axes bar{x0, y0, x1, y1, {{0, low}, {1, high > low ? high : low + 1}}};
  for (int y = bar.y0; y < bar.y1; ++y)
    for (int x = x0; x < x1; ++x) image.at(x, y) = color_at(*layer.map, (bar.y1 - y - 0.5) / (bar.y1 - bar.y0));
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
  const int count = std::clamp(static_cast<int>((bottom - top) / (60 * unit)), 2, 6);
  for (const auto& [value, text] : ticks(low, high, count))
    if (std::min(bar.pixel({0, value}).y() - top, bottom - bar.pixel({0, value}).y()) > 2.2 * size) mark(value, text);
}

/// The stresses in the solids over faint schlieren of the gas.
void draw_stress(Image& image, const Axes& axes, const Snapshot& snapshot, const RenderOptions& options, double unit) {
  const Layer stress = stress_layer(snapshot, options.range);
  const auto has_density = [](const GridSnapshot& grid) { return grid.field("density") != nullptr; };
  if (std::any_of(snapshot.grids.begin(), snapshot.grids.end(), has_density)) {
    Layer schlieren = field_layer(snapshot, "schlieren", {});
    schlieren.strength = faint;
    paint(image, axes, snapshot, schlieren, false);
  }
  paint(image, axes, snapshot, stress, true);
  image.clip_to_all();
  draw_bar(image, axes, axes.y0, axes.y1, stress, unit);
}

}  // namespace

void draw_field(Image& image, const Axes& axes, const Snapshot& snapshot, const RenderOptions& options, double unit) {
  if (options.field == "stress") return draw_stress(image, axes, snapshot, options, unit);
  const Layer layer = field_layer(snapshot, options.field, options.range);
  paint(image, axes, snapshot, layer, false);
  const bool shared = holds_data(snapshot, layer.values, true), stressed = has_solids(snapshot) && !shared;
  if (shared) paint(image, axes, snapshot, layer, true);
  const int height = axes.y1 - axes.y0, middle = axes.y0 + (stressed ? height * 11 / 20 : height);
  if (!layer.schlieren) {
    image.clip_to_all();
    draw_bar(image, axes, axes.y0, middle, layer, unit);
    image.clip_to(axes.x0, axes.y0, axes.x1, axes.y1);
  }
  if (!stressed) return;
  const Layer stress = stress_layer(snapshot, {});
  paint(image, axes, snapshot, stress, true);
  image.clip_to_all();
  const int top = axes.y0 + height * 13 / 20;
  draw_label(image, axes.x1 + 16 * unit, top - 9 * unit, "von Mises", 11 * unit, image.width() - axes.x1 - 18 * unit,
             Align::left);
  draw_bar(image, axes, top, axes.y1, stress, unit);
}

}  // namespace mortise
