#include "mortise/cases/pictures/render.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/pictures/picture_kinds.hpp"

namespace mortise {
namespace {

constexpr double tallest = 1.25;  // height of the axes over their widest width

Box<2> shown(const Snapshot& snapshot, const Box<2>& window) {
  if ((window.low.array() < window.high.array()).all() || snapshot.grids.empty()) return window;
  Box<2> box;
  const GridSnapshot& grid = snapshot.grids.front();
  for (std::size_t k = 0; k < grid.x.size(); ++k) box.include({grid.x[k], grid.y[k]});
  return box;
}

/// Room for labels at the left and below, for the title above, for the colour bar at the right.
Axes placed(const Box<2>& window, int width, double unit, bool bar) {
  const double left = 66 * unit, right = (bar ? 104 : 24) * unit, room = width - left - right;
  const Point<2> extent = window.high - window.low;
  const double scale = std::min(room / extent.x(), tallest * room / extent.y());  // pixels per unit of length
  const int w = std::max(1, static_cast<int>(std::lround(scale * extent.x()))),
            h = std::max(1, static_cast<int>(std::lround(scale * extent.y())));
  const int x0 = static_cast<int>(std::lround(left + 0.5 * (room - w))), y0 = static_cast<int>(std::lround(44 * unit));
  return {x0, y0, x0 + w, y0 + h, window};
}

void draw_bodies(Image& image, const Axes& axes, const Snapshot& snapshot, double unit) {
  for (const std::vector<Point<2>>& outline : snapshot.outlines) {
    const std::vector<Point<2>> corners = axes.pixels(outline);
    image.fill_polygon(corners, ink::body);
    image.draw_polyline(corners, 1.8 * unit, ink::edge, true);
  }
}

}  // namespace

void draw_title(Image& image, const Axes& axes, const std::string& title, double time, double unit) {
  const double baseline = axes.y0 - 13 * unit, size = 14 * unit;
  draw_text(image, axes.x0, baseline, title, size, ink::text);
  draw_text(image, axes.x1, baseline, "t = " + fixed(time, 4), size, ink::text, Align::right);
}

Image render(const Snapshot& snapshot, const RenderOptions& options) {
  const int width = std::max(options.width, 64) / 2 * 2;
  const double unit = width / 1200.0;
  if (!snapshot.grids.empty() && snapshot.grids.front().dimension == 1) return plot_lines(snapshot, options, unit);
  const bool grids = options.field == "grids";
  const Axes axes = placed(shown(snapshot, options.window), width, unit, !grids && options.field != "schlieren");
  Image image(width, (axes.y1 + static_cast<int>(std::lround(42 * unit)) + 1) / 2 * 2);
  image.clip_to(axes.x0, axes.y0, axes.x1, axes.y1);
  if (grids)
    draw_grids(image, axes, snapshot, unit);
  else
    draw_field(image, axes, snapshot, options, unit);
  image.clip_to(axes.x0, axes.y0, axes.x1, axes.y1);
  draw_bodies(image, axes, snapshot, unit);
  image.clip_to_all();
  draw_axes(image, axes, unit);
  draw_title(image, axes, options.title.empty() ? options.field : options.title + "   " + options.field, snapshot.time,
             unit);
  return image;
}

}  // namespace mortise
