// Overlapping grids whose bodies change shape, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/overlap/overlap.hpp"

namespace mortise::testing {

using AtlasPointer = std::shared_ptr<const BodyAtlas>;
using Curve = std::vector<Point<2>>;

inline constexpr double unset = 1e30;

/// A background on a square in tiles of ten cells, and body grids of any shape in it, carrying one scalar.
class DeformingScene {
 public:
  DeformingScene(double spacing, double half_width, const std::vector<AtlasPointer>& atlases, OverlapOptions options,
                 Communicator comm = Communicator())
      : comm_(comm) {
    const int n = 10 * static_cast<int>(std::lround(half_width / (5 * spacing)));
    grids_.emplace_back("background", comm_, Index<2>{n, n}, std::array<bool, 2>{false, false}, TileShape<2>({10, 10}));
    grids_[0].origin = Point<2>::Constant(-n * spacing / 2);
    grids_[0].spacing = {spacing, spacing};
    std::vector<OverlapBody<2>> bodies;
    for (const AtlasPointer& atlas : atlases) {
      const GrownGrid& grid = atlas->grid();
      const Index<2> cells{grid.along, grid.layers};
      grids_.emplace_back("body", comm_, cells, std::array<bool, 2>{true, false}, TileShape<2>({grid.along / 4, grid.layers}));
      grids_.back().body = static_cast<int>(bodies.size());
      bodies.push_back({atlas, grid.thickness, grid.layers});
      atlases_.push_back(atlas);
    }
    for (const ComponentGrid<2>& grid : grids_) fields_.emplace_back(grid.shape, 1, grid.forest.local_count());
    for (const ComponentGrid<2>& grid : grids_) exchanges_.emplace_back(grid.forest, grid.shape, 1);
    const Box<2> domain{grids_[0].origin, -grids_[0].origin};
    overlap_ = std::make_unique<Overlap<2>>(comm_, grids_, bodies, domain, options);
    poses_.resize(bodies.size());
    overlap_->update(poses_, true);
  }

  void reshape(std::size_t body, const AtlasPointer& atlas) {
    atlases_[body] = atlas;
    overlap_->reshape(body, atlas);
  }

  bool update() { return overlap_->update(poses_, false); }

  /// The largest interpolation error of f in fringe and exposed cells of the grids from `first` on, after an update if
  /// `moved`.
  template <class F>
  double step(bool moved, std::size_t first, F&& f) {
    std::vector<std::uint8_t> before, now;
    for_all([&](std::size_t, const TileMask& mask, std::size_t k, const Point<2>&, double&) { before.push_back(active(mask, k)); });
    if (moved) {
      EXPECT_TRUE(update());
    }
    EXPECT_EQ(overlap_->report().orphans, 0) << overlap_->report().first_orphan;
    std::size_t cell = 0;
    for_all([&](std::size_t, const TileMask& mask, std::size_t k, const Point<2>& x, double& value) {
      const bool was_active = before[cell++];
      value = active(mask, k) && was_active ? f(x) : unset;
    });
    return error(first, f);
  }

  template <class Visit>
  void for_all(Visit&& visit) {
    for (std::size_t g = 0; g < grids_.size(); ++g)
      for (int t = 0; t < fields_[g].tiles(); ++t)
        for_each_cell<2>(grids_[g].shape, 0, [&](const Index<2>& c) {
          const Index<2> from = grids_[g].first_cell(t);
          const Index<2> global{from[0] + c[0], from[1] + c[1]};
          const bool background = grids_[g].background();
          const Point<2> x = background ? grids_[g].center(global)
                                        : atlases_[static_cast<std::size_t>(grids_[g].body)]->center(global[0], global[1]);
          const std::size_t k = grids_[g].shape.at(c);
          visit(g, grids_[g].masks[static_cast<std::size_t>(t)], k, x, fields_[g].tile(t).component(0)[k]);
        });
  }

  std::vector<CellState> states() {
    std::vector<CellState> all;
    for_all([&](std::size_t, const TileMask& mask, std::size_t k, const Point<2>&, double&) { all.push_back(state(mask, k)); });
    return all;
  }

  static CellState state(const TileMask& mask, std::size_t k) { return mask.cut() ? mask.state[k] : CellState::active; }
  const Overlap<2>& overlap() const { return *overlap_; }

 private:
  static bool active(const TileMask& mask, std::size_t k) { return !mask.cut() || mask.active[k]; }

  template <class F>
  double error(std::size_t first, F&& f) {
    const double filler[] = {unset};
    for (std::size_t g = 0; g < grids_.size(); ++g) exchanges_[g].fill(fields_[g], filler);
    const auto same = [](const double* from, double* to) { *to = *from; };
    overlap_->fill<1>(fields_, same, same);
    double largest = 0;
    for_all([&](std::size_t g, const TileMask& mask, std::size_t k, const Point<2>& x, double& value) {
      if (g >= first && state(mask, k) != CellState::hole) largest = std::max(largest, std::abs(value - f(x)));
    });
    return largest;
  }

  Communicator comm_;
  std::vector<ComponentGrid<2>> grids_;
  std::vector<AtlasPointer> atlases_;
  std::vector<Field<2>> fields_;
  std::vector<GhostExchange<2>> exchanges_;
  std::vector<Pose<2>> poses_;
  std::unique_ptr<Overlap<2>> overlap_;
};

/// An ellipse turned by `angle`, clockwise, or counter-clockwise for inward grids.
inline Curve ellipse(double a, double b, double angle, int count, bool inward) {
  Curve curve;
  for (int i = 0; i < count; ++i) {
    const double t = (inward ? 2 : -2) * std::numbers::pi * i / count;
    const Point<2> x(a * std::cos(t), b * std::sin(t));
    curve.push_back({std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1]});
  }
  return curve;
}

inline AtlasPointer atlas_of(const Curve& curve, double spacing, int layers, bool inward) {
  const GrowthOptions options{.spacing = spacing, .layers = layers, .inward = inward};
  return std::make_shared<const BodyAtlas>(grow_from(curve, options, 4), inward);
}

}  // namespace mortise::testing
