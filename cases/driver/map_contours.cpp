#include "mortise/cases/driver/map_contours.hpp"

#include <cmath>
#include <map>

namespace mortise {
namespace {

using Polyline = std::vector<Point<2>>;

/// Numbers of the edges between neighbouring samples: 2 n leads from sample n in direction 0, 2 n + 1 in direction 1.
struct Edges {
  const MapSamples& samples;
  const ComponentGrid<2>& grid;

  int of(int i, int j, int direction) const { return 2 * (j * samples.size[0] + i) + direction; }
  /// Those of a square: bottom, right, top, left.
  std::array<int, 4> around(int i, int j) const { return {of(i, j, 0), of(i + 1, j, 1), of(i, j + 1, 0), of(i, j, 1)}; }
  std::array<std::size_t, 2> ends(int edge) const {
    const int n = edge / 2;
    return {static_cast<std::size_t>(n), static_cast<std::size_t>(n + (edge % 2 ? samples.size[0] : 1))};
  }
  /// The point at s of the way.
  Point<2> at(int edge, double s) const {
    const int n = edge / 2, i = n % samples.size[0], j = n / samples.size[0];
    const Point<2> from = grid.center({samples.low[0] + i, samples.low[1] + j});
    return from + s * (edge % 2 ? Point<2>(0, grid.spacing.y()) : Point<2>(grid.spacing.x(), 0));
  }
};

/// Lines φ = 0: marching squares, saddles joined through their middle value.
class Surfaces {
 public:
  Surfaces(const MapSamples& samples, const ComponentGrid<2>& grid) : samples_(samples), edges_{samples, grid} {}

  std::vector<Polyline> polygons() {
    for (int j = 0; j + 1 < samples_.size[1]; ++j)
      for (int i = 0; i + 1 < samples_.size[0]; ++i) square(i, j);
    std::vector<Polyline> all;
    while (!links_.empty()) {
      Polyline polygon;
      for (int edge = links_.begin()->first; links_.contains(edge);) {
        polygon.push_back(crossing(edge));
        const int next = links_[edge];
        links_.erase(edge);
        edge = next;
      }
      if (polygon.size() > 2) all.push_back(std::move(polygon));
    }
    return all;
  }

 private:
  double phi(int i, int j) const { return samples_.phi[static_cast<std::size_t>(j * samples_.size[0] + i)]; }

  Point<2> crossing(int edge) const {
    const auto [from, to] = edges_.ends(edge);
    const double a = samples_.phi[from], b = samples_.phi[to];
    return edges_.at(edge, a / (a - b));
  }

  /// Links of the edges of one square; the inside is on the left of every link.
  void square(int i, int j) {
    const bool corner[] = {phi(i, j) < 0, phi(i + 1, j) < 0, phi(i + 1, j + 1) < 0, phi(i, j + 1) < 0};
    const std::array<int, 4> edges = edges_.around(i, j);
    std::vector<int> entries, exits;  // going round counter-clockwise: into the inside, out of it
    for (int k = 0; k < 4; ++k) {
      const bool here = corner[k], next = corner[(k + 1) % 4];
      if (!here && next) entries.push_back(k);
      if (here && !next) exits.push_back(k);
    }
    const bool middle = phi(i, j) + phi(i + 1, j) + phi(i + 1, j + 1) + phi(i, j + 1) < 0;
    for (const int entry : entries) {
      // Where the inside is joined through the middle an exit belongs to the entry behind it, else to that before it.
      int best = exits[0];
      for (const int exit : exits) {
        const auto turn = [&](int e) { return (e - entry + 4) % 4; };
        if (middle ? turn(exit) > turn(best) : turn(exit) < turn(best)) best = exit;
      }
      links_[edges[static_cast<std::size_t>(best)]] = edges[static_cast<std::size_t>(entry)];
    }
  }

  const MapSamples& samples_;
  Edges edges_;
  std::map<int, int> links_;
};

/// One line ξ_c = level, through the squares that touch the inside.
class Line {
 public:
  Line(const MapSamples& samples, const ComponentGrid<2>& grid, int component, double level)
      : samples_(samples), edges_{samples, grid}, component_(component), level_(level) {}

  /// The pieces of it inside.
  std::vector<Polyline> pieces() {
    for (int j = 0; j + 1 < samples_.size[1]; ++j)
      for (int i = 0; i + 1 < samples_.size[0]; ++i) square(i, j);
    std::vector<Polyline> all;
    for (const bool loops : {false, true})  // what has ends first, then what has none
      while (const std::optional<int> start = next_start(loops)) cut(chain_from(*start), all);
    return all;
  }

 private:
  double value(std::size_t k) const { return samples_.xi[k][component_] - level_; }

  void square(int i, int j) {
    const std::array<int, 4> edges = edges_.around(i, j);
    bool touches = false, known = true;
    for (const int edge : {edges[0], edges[2]})
      for (const std::size_t k : edges_.ends(edge)) {
        touches = touches || samples_.phi[k] < 0;
        known = known && samples_.phi[k] < unknown_phi;
      }
    if (!touches || !known) return;
    std::vector<int> crossed;
    for (const int edge : edges) {
      const auto [from, to] = edges_.ends(edge);
      if ((value(from) < 0) != (value(to) < 0)) crossed.push_back(edge);
    }
    for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {  // two; four at saddles
      neighbors_[crossed[k]].push_back(crossed[k + 1]);
      neighbors_[crossed[k + 1]].push_back(crossed[k]);
    }
  }

  std::optional<int> next_start(bool loops) const {
    for (const auto& [edge, neighbors] : neighbors_)
      if (loops || neighbors.size() == 1) return edge;
    return std::nullopt;
  }

  /// The edges of a chain, which is taken out.
  std::vector<int> chain_from(int edge) {
    std::vector<int> chain;
    while (true) {
      chain.push_back(edge);
      const auto here = neighbors_.find(edge);
      if (here == neighbors_.end()) return chain;
      int next = -1;
      for (const int neighbor : here->second)
        if (neighbors_.contains(neighbor)) next = neighbor;
      neighbors_.erase(here);
      if (next < 0) return chain;
      edge = next;
    }
  }

  /// Appends the stretches of a chain with φ < 0, which end where φ, linear along the chain, is 0.
  void cut(const std::vector<int>& chain, std::vector<Polyline>& all) const {
    Polyline piece;
    Point<2> last = Point<2>::Zero();
    double last_phi = 1;
    const auto close = [&] {
      if (piece.size() > 1) all.push_back(piece);
      piece.clear();
    };
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const auto [from, to] = edges_.ends(chain[k]);
      const double s = value(from) / (value(from) - value(to));
      const Point<2> x = edges_.at(chain[k], s);
      const double phi = (1 - s) * samples_.phi[from] + s * samples_.phi[to];
      if (k > 0 && (phi < 0) != (last_phi < 0)) piece.push_back(last + last_phi / (last_phi - phi) * (x - last));
      if (phi < 0)
        piece.push_back(x);
      else
        close();
      last = x, last_phi = phi;
    }
    close();
  }

  const MapSamples& samples_;
  Edges edges_;
  int component_;
  double level_;
  std::map<int, std::vector<int>> neighbors_;  // of edges that are crossed
};

}  // namespace

std::vector<Polyline> surfaces_of(const MapSamples& samples, const ComponentGrid<2>& grid) {
  return Surfaces(samples, grid).polygons();
}

std::vector<Polyline> lines_of(const MapSamples& samples, const ComponentGrid<2>& grid, const Point<2>& center,
                               double spacing) {
  Box<2> values;
  for (std::size_t k = 0; k < samples.phi.size(); ++k)
    if (samples.phi[k] < 0) values.include(samples.xi[k]);
  std::vector<Polyline> all;
  for (int c = 0; c < 2; ++c)
    for (double k = std::ceil((values.low[c] - center[c]) / spacing); center[c] + k * spacing < values.high[c]; ++k)
      for (Polyline& piece : Line(samples, grid, c, center[c] + k * spacing).pieces()) all.push_back(std::move(piece));
  return all;
}

Box<2> reference_box(const LevelSet& level_set, double distance) {
  const Box<2> around = level_set.box();
  Box<2> box;
  for (double y = around.low.y(); y < around.high.y(); y += distance)
    for (double x = around.low.x(); x < around.high.x(); x += distance)
      if (level_set(x, y) < 0) box.include({x, y});
  return box;
}

}  // namespace mortise
