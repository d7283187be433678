#include "mortise/cases/pictures/render.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/pictures/picture_kinds.hpp"
#include "mortise/cases/pictures/picture_values.hpp"

namespace mortise {
namespace {

constexpr double tallest = 1.25;  // height of the axes over their widest width

/// All of the first grid of a fluid and the active cells of the others; around solids alone a little more.
Box<2> shown(const Snapshot& snapshot, const Box<2>& window) {
  if ((window.low.array() < window.high.array()).all() || snapshot.grids.empty()) return window;
  Box<2> box;
  for (const GridSnapshot& grid : snapshot.grids) {
    const bool all = &grid == &snapshot.grids.front() && !grid.solid;
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int i = 0; i < grid.cells[0]; ++i)
        if (all || grid.mask[grid.cell(i, j)] == mask_active)
          for (const std::size_t k :
               {grid.node(i, j), grid.node(i + 1, j), grid.node(i, j + 1), grid.node(i + 1, j + 1)})
            box.include({grid.x[k], grid.y[k]});
  }
  return snapshot.grids.front().solid ? box.grown(0.03 * (box.high - box.low).maxCoeff()) : box;
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

void draw_surfaces(Image& image, const Axes& axes, const Snapshot& snapshot, double unit) {
  for (const std::vector<Point<2>>& surface : snapshot.surfaces) image.draw_polyline(axes.pixels(surface), 1.8 * unit, ink::edge, true);
}

void draw_contours(Image& image, const Axes& axes, const Snapshot& snapshot, double unit) {
  for (const std::vector<Point<2>>& line : snapshot.contours)
    image.draw_polyline(axes.pixels(line), 1.0 * unit, ink::frame);
}

/// Where the solids end: the edges of active cells at the edge of their grid. Where a grid is closed or continued by
/// another one there is no such edge.
void draw_solid_edges(Image& image, const Axes& axes, const Snapshot& snapshot, double unit) {
  for (const GridSnapshot& grid : snapshot.grids) {
    if (!grid.solid) continue;
    const int n = grid.cells[0], m = grid.cells[1];
    const auto draw = [&](int i, int j, std::size_t from, std::size_t to) {
      if (grid.mask[grid.cell(i, j)] != mask_active) return;
      image.draw_polyline(axes.pixels({{grid.x[from], grid.y[from]}, {grid.x[to], grid.y[to]}}), 1.8 * unit, ink::edge);
    };
    for (int i = 0; i < n; ++i) {
      draw(i, 0, grid.node(i, 0), grid.node(i + 1, 0));
      draw(i, m - 1, grid.node(i, m), grid.node(i + 1, m));
    }
    for (int j = 0; j < m && !closed_along(grid); ++j) {
      draw(0, j, grid.node(0, j), grid.node(0, j + 1));
      draw(n - 1, j, grid.node(n, j), grid.node(n, j + 1));
    }
  }
}

}  // namespace

void draw_title(Image& image, const Axes& axes, const std::string& title, double time, double unit) {
  const double baseline = axes.y0 - 13 * unit, size = 14 * unit;
  const std::string when = "t = " + fixed(time, 4);
  // Beside each other, beyond narrow axes if need be.
  const double between = text_width(when, size) + 2 * size;
  const double end = std::clamp(axes.x0 + text_width(title, size) + between, static_cast<double>(axes.x1),
                                std::max<double>(axes.x1, image.width() - size));
  draw_label(image, axes.x0, baseline, title, size, end - between - axes.x0, Align::left);
  draw_text(image, end, baseline, when, size, ink::text, Align::right);
}

Image render(const Snapshot& snapshot, const RenderOptions& options) {
  const int width = std::max(options.width, 64) / 2 * 2;
  const double unit = width / 1200.0;
  if (!snapshot.grids.empty() && snapshot.grids.front().dimension == 1) return plot_lines(snapshot, options, unit);
  const bool grids = options.field == "grids";
  const bool bar = !grids && (options.field != "schlieren" || has_solids(snapshot));
  const Axes axes = placed(shown(snapshot, options.window), width, unit, bar);
  Image image(width, (axes.y1 + static_cast<int>(std::lround(42 * unit)) + 1) / 2 * 2);
  image.clip_to(axes.x0, axes.y0, axes.x1, axes.y1);
  if (grids)
    draw_grids(image, axes, snapshot, unit);
  else
    draw_field(image, axes, snapshot, options, unit);
  image.clip_to(axes.x0, axes.y0, axes.x1, axes.y1);
  draw_bodies(image, axes, snapshot, unit);
  if (snapshot.surfaces.empty()) draw_solid_edges(image, axes, snapshot, unit);
  draw_contours(image, axes, snapshot, unit);
  draw_surfaces(image, axes, snapshot, unit);
  image.clip_to_all();
  draw_axes(image, axes, unit);
  draw_title(image, axes, options.title.empty() ? options.field : options.title + "   " + options.field, snapshot.time,
             unit);
  return image;
}

}  // namespace mortise
