#include <algorithm>
#include <cmath>

#include "mortise/cases/pictures/picture_kinds.hpp"

namespace mortise {
namespace {

constexpr Rgb curve_ink{24, 84, 168}, dot_ink{12, 52, 116};

/// Cell centres and values of one run of neighbouring active cells.
using Curve = std::vector<Point<2>>;

std::vector<Curve> curves(const GridSnapshot& grid, const std::vector<double>& values) {
  std::vector<Curve> result;
  bool open = false;
  for (int i = 0; i < grid.cells[0]; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool shown = grid.mask[k] == mask_active && std::isfinite(values[k]);
    if (shown && !open) result.emplace_back();
    if (shown) result.back().emplace_back(0.5 * (grid.x[k] + grid.x[k + 1]), values[k]);
    open = shown;
  }
  return result;
}

std::vector<Curve> all_curves(const Snapshot& snapshot, const std::string& field) {
  std::vector<Curve> all;
  for (const GridSnapshot& grid : snapshot.grids)
    if (const auto* values = grid.field(field))
      for (Curve& curve : curves(grid, *values)) all.push_back(std::move(curve));
  return all;
}

/// x as asked for or of the first grid; y from the curves with a margin.
Box<2> window_of(const std::vector<Curve>& curves, const Snapshot& snapshot, const Box<2>& asked) {
  Box<2> box;
  for (const Curve& curve : curves)
    for (const Point<2>& point : curve) box.include(point);
  if (curves.empty()) box.low.y() = box.high.y() = 0;
  const auto [left, right] = std::minmax_element(snapshot.grids.front().x.begin(), snapshot.grids.front().x.end());
  const bool given = asked.low.x() < asked.high.x();
  box.low.x() = given ? asked.low.x() : *left;
  box.high.x() = given ? asked.high.x() : *right;
  const double middle = 0.5 * (box.low.y() + box.high.y());
  const double half = std::max({0.56 * (box.high.y() - box.low.y()), 1e-3 * std::fabs(middle), 1e-9});
  box.low.y() = middle - half;
  box.high.y() = middle + half;
  return box;
}

void draw_panel(Image& image, const Axes& axes, const std::vector<Curve>& curves, const Snapshot& snapshot,
                double unit) {
  image.clip_to(axes.x0, axes.y0, axes.x1, axes.y1);
  const double top = axes.y0, bottom = axes.y1;
  for (const auto& [y, text] :
       ticks(axes.window.low.y(), axes.window.high.y(), std::max(2, static_cast<int>((bottom - top) / (70 * unit))))) {
    const double at = axes.pixel({0, y}).y();
    image.draw_polyline({{axes.x0, at}, {axes.x1, at}}, 1.0 * unit, ink::rule);
  }
  for (const std::vector<Point<2>>& body : snapshot.outlines) {
    Box<2> box;
    for (const Point<2>& point : body) box.include(point);
    const double left = axes.pixel(box.low).x(), right = axes.pixel(box.high).x();
    image.fill_polygon({{left, top}, {right, top}, {right, bottom}, {left, bottom}}, ink::body);
    for (const double x : {left, right}) image.draw_polyline({{x, top}, {x, bottom}}, 1.5 * unit, ink::edge);
  }
  for (const Curve& curve : curves) {
    const std::vector<Point<2>> points = axes.pixels(curve);
    image.draw_polyline(points, 2.2 * unit, curve_ink);
    if (curve.size() > 1 && std::fabs(points[1].x() - points[0].x()) < 9 * unit) continue;
    for (const Point<2>& point : points) image.draw_polyline({point}, 5.5 * unit, dot_ink);  // few cells: show them
  }
  image.clip_to_all();
}

}  // namespace

Image plot_lines(const Snapshot& snapshot, const RenderOptions& options, double unit) {
  struct Panel {
    const char *field, *name;
  };
  constexpr Panel panels[] = {{"density", "density"}, {"velocity_x", "velocity"}, {"pressure", "pressure"}};
  const auto pixels = [unit](double length) { return static_cast<int>(std::lround(length * unit)); };
  const int width = pixels(1200), height = pixels(232), gap = pixels(18), left = pixels(98), top = pixels(44);
  Image image(width, (top + 3 * height + 2 * gap + pixels(42) + 1) / 2 * 2);
  int y0 = top;
  for (const Panel& panel : panels) {
    const std::vector<Curve> shown = all_curves(snapshot, panel.field);
    const Axes axes{left, y0, width - pixels(24), y0 + height, window_of(shown, snapshot, options.window)};
    draw_panel(image, axes, shown, snapshot, unit);
    const bool last = &panel == std::end(panels) - 1;
    draw_axes(image, axes, unit, last);
    draw_text_upwards(image, 26 * unit, 0.5 * (axes.y0 + axes.y1), panel.name, 13 * unit, ink::text);
    if (y0 == top) draw_title(image, axes, options.title, snapshot.time, unit);
    y0 += height + gap;
  }
  return image;
}

}  // namespace mortise
