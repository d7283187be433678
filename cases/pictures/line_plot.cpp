#include <algorithm>
#include <cmath>

#include "mortise/cases/pictures/picture_kinds.hpp"

namespace mortise {
namespace {

constexpr Rgb curve_ink{24, 84, 168}, dot_ink{12, 52, 116};
constexpr Rgb solid_curve_ink{190, 70, 20}, solid_dot_ink{130, 40, 8}, solid_shade{255, 244, 226};

/// Centres and values of one run of neighbouring active cells.
struct Curve {
  std::vector<Point<2>> points;
  bool solid = false;
};

/// A grid as a line: the row of cells along the middle of its longer direction, measured along a direction in space.
class Line {
 public:
  Line(const GridSnapshot& grid, const Point<2>& direction)
      : grid_(grid), direction_(direction), along_(grid.cells[0] >= grid.cells[1] ? 0 : 1) {}

  int cells() const { return grid_.cells[along_]; }
  std::size_t cell(int k) const {
    const int middle = grid_.cells[1 - along_] / 2;
    return along_ == 0 ? grid_.cell(k, middle) : grid_.cell(middle, k);
  }
  /// Place of a face, 0 ≤ k ≤ cells(): the mean of its two nodes.
  Point<2> face(int k) const {
    const int middle = grid_.cells[1 - along_] / 2;
    const std::size_t a = along_ == 0 ? grid_.node(k, middle) : grid_.node(middle, k),
                      b = along_ == 0 ? grid_.node(k, middle + 1) : grid_.node(middle + 1, k);
    return {0.5 * (grid_.x[a] + grid_.x[b]), 0.5 * (grid_.y[a] + grid_.y[b])};
  }
  double at_face(int k) const { return direction_.dot(face(k)); }
  double at_cell(int k) const { return 0.5 * (at_face(k) + at_face(k + 1)); }
  bool active(int k) const { return grid_.mask[cell(k)] == mask_active; }

 private:
  const GridSnapshot& grid_;
  Point<2> direction_;
  std::size_t along_;
};

/// x for lines; for strips the way they run, rightwards or upwards.
Point<2> common_direction(const Snapshot& snapshot) {
  const GridSnapshot& grid = snapshot.grids.front();
  if (grid.cells[1] == 1) return {1, 0};
  const Line line(grid, {1, 0});
  const Point<2> way = (line.face(line.cells()) - line.face(0)).normalized();
  return (std::fabs(way.x()) > std::fabs(way.y()) ? way.x() : way.y()) < 0 ? Point<2>(-way) : way;
}

/// What a panel shows of one cell of a grid: a scalar, v·n or −n·σn.
using Quantity = std::vector<double> (*)(const GridSnapshot&, const Point<2>& n);

std::vector<double> density(const GridSnapshot& grid, const Point<2>&) {
  const auto* values = grid.field("density");
  return values ? *values : std::vector<double>{};
}

std::vector<double> normal_velocity(const GridSnapshot& grid, const Point<2>& n) {
  const auto *u = grid.field("velocity_x"), *v = grid.field("velocity_y");
  if (!u) return {};
  std::vector<double> values(u->size());
  for (std::size_t c = 0; c < values.size(); ++c) values[c] = n.x() * (*u)[c] + (v ? n.y() * (*v)[c] : 0.0);
  return values;
}

std::vector<double> pressure(const GridSnapshot& grid, const Point<2>& n) {
  if (const auto* values = grid.field("pressure")) return *values;
  const auto *xx = grid.field("stress_xx"), *xy = grid.field("stress_xy"), *yy = grid.field("stress_yy");
  if (!xx || !xy || !yy) return {};
  std::vector<double> values(xx->size());
  for (std::size_t c = 0; c < values.size(); ++c)
    values[c] = -(n.x() * n.x() * (*xx)[c] + 2 * n.x() * n.y() * (*xy)[c] + n.y() * n.y() * (*yy)[c]);
  return values;
}

std::vector<Curve> curves(const Snapshot& snapshot, Quantity quantity, const Point<2>& n) {
  std::vector<Curve> all;
  for (const GridSnapshot& grid : snapshot.grids) {
    const std::vector<double> values = quantity(grid, n);
    const Line line(grid, n);
    bool open = false;
    for (int k = 0; !values.empty() && k < line.cells(); ++k) {
      const double value = values[line.cell(k)];
      const bool shown = line.active(k) && std::isfinite(value);
      if (shown && !open) all.push_back({{}, grid.solid});
      if (shown) all.back().points.emplace_back(line.at_cell(k), value);
      open = shown;
    }
  }
  return all;
}

/// x as asked for, or of the first grid and the active cells of the others; y from the curves with a margin.
Box<2> window_of(const std::vector<Curve>& curves, const Snapshot& snapshot, const Point<2>& n, const Box<2>& asked) {
  Box<2> box;
  for (const Curve& curve : curves)
    for (const Point<2>& point : curve.points) box.include(point);
  double left = 1e300, right = -1e300;
  for (const GridSnapshot& grid : snapshot.grids) {
    const Line line(grid, n);
    for (int k = 0; k < line.cells(); ++k) {
      if (&grid != &snapshot.grids.front() && !line.active(k)) continue;
      left = std::min({left, line.at_face(k), line.at_face(k + 1)});
      right = std::max({right, line.at_face(k), line.at_face(k + 1)});
    }
  }
  const bool given = asked.low.x() < asked.high.x();
  box.low.x() = given ? asked.low.x() : left;
  box.high.x() = given ? asked.high.x() : right;
  const double middle = 0.5 * (box.low.y() + box.high.y());
  const double half = std::max({0.56 * (box.high.y() - box.low.y()), 1e-3 * std::fabs(middle), 1e-9});
  box.low.y() = middle - half;
  box.high.y() = middle + half;
  return box;
}

/// Shades [left, right] with dark edges.
void shade(Image& image, const Axes& axes, double left, double right, Rgb color, double unit) {
  const double top = axes.y0, bottom = axes.y1, x0 = axes.pixel({left, 0}).x(), x1 = axes.pixel({right, 0}).x();
  image.fill_polygon({{x0, top}, {x1, top}, {x1, bottom}, {x0, bottom}}, color);
  for (const double x : {x0, x1}) image.draw_polyline({{x, top}, {x, bottom}}, 1.5 * unit, ink::edge);
}

void shade_solids(Image& image, const Axes& axes, const Snapshot& snapshot, const Point<2>& n, double unit) {
  for (const GridSnapshot& grid : snapshot.grids) {
    if (!grid.solid) continue;
    const Line line(grid, n);
    const auto [left, right] = std::minmax({line.at_face(0), line.at_face(line.cells())});
    shade(image, axes, left, right, solid_shade, unit);
  }
}

void draw_panel(Image& image, const Axes& axes, const std::vector<Curve>& curves, const Snapshot& snapshot,
                const Point<2>& n, double unit) {
  image.clip_to(axes.x0, axes.y0, axes.x1, axes.y1);
  shade_solids(image, axes, snapshot, n, unit);
  for (const auto& [y, text] : ticks(axes.window.low.y(), axes.window.high.y(),
                                     std::max(2, static_cast<int>((axes.y1 - axes.y0) / (70 * unit))))) {
    const double at = axes.pixel({0, y}).y();
    image.draw_polyline({{axes.x0, at}, {axes.x1, at}}, 1.0 * unit, ink::rule);
  }
  for (const std::vector<Point<2>>& body : snapshot.outlines) {
    Box<2> box;
    for (const Point<2>& point : body) box.include(point);
    shade(image, axes, box.low.x(), box.high.x(), ink::body, unit);
  }
  for (const Curve& curve : curves) {
    const std::vector<Point<2>> points = axes.pixels(curve.points);
    image.draw_polyline(points, 2.2 * unit, curve.solid ? solid_curve_ink : curve_ink);
    if (points.size() > 1 && std::fabs(points[1].x() - points[0].x()) < 9 * unit) continue;
    for (const Point<2>& point : points)  // few cells: show them
      image.draw_polyline({point}, 5.5 * unit, curve.solid ? solid_dot_ink : dot_ink);
  }
  image.clip_to_all();
}

struct Panel {
  std::string name;
  std::vector<Curve> curves;
};

/// Those that have something to show.
std::vector<Panel> panels(const Snapshot& snapshot, const Point<2>& n) {
  std::vector<Panel> all = {{"density", curves(snapshot, density, n)},
                            {"velocity", curves(snapshot, normal_velocity, n)},
                            {"pressure", curves(snapshot, pressure, n)}};
  const auto solid = [](const Curve& curve) { return curve.solid; };
  const std::vector<Curve>& last = all.back().curves;
  if (std::any_of(last.begin(), last.end(), solid))
    all.back().name = std::all_of(last.begin(), last.end(), solid) ? "-stress" : "pressure, -stress";
  std::erase_if(all, [](const Panel& panel) { return panel.curves.empty(); });
  return all;
}

}  // namespace

Image plot_lines(const Snapshot& snapshot, const RenderOptions& options, double unit) {
  const Point<2> n = common_direction(snapshot);
  const std::vector<Panel> shown = panels(snapshot, n);
  const auto pixels = [unit](double length) { return static_cast<int>(std::lround(length * unit)); };
  const int width = pixels(1200), height = pixels(232), gap = pixels(18), left = pixels(98), top = pixels(44);
  const int count = std::max(1, static_cast<int>(shown.size()));
  Image image(width, (top + count * height + (count - 1) * gap + pixels(42) + 1) / 2 * 2);
  int y0 = top;
  for (const Panel& panel : shown) {
    const Axes axes{left, y0, width - pixels(24), y0 + height, window_of(panel.curves, snapshot, n, options.window)};
    draw_panel(image, axes, panel.curves, snapshot, n, unit);
    draw_axes(image, axes, unit, &panel == &shown.back());
    draw_text_upwards(image, 26 * unit, 0.5 * (axes.y0 + axes.y1), panel.name, 13 * unit, ink::text);
    if (y0 == top) draw_title(image, axes, options.title, snapshot.time, unit);
    y0 += height + gap;
  }
  return image;
}

}  // namespace mortise
