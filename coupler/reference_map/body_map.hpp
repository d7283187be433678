// The reference map of one body on the tiles near it: where the material at a point came from,
//   ξ_t + (v·∇)ξ = 0.
// Inside the body, φ(ξ) < 0, ξ moves with the material. Around it, in a band a few cells wide, it is continued: layer
// by layer outward, each cell from the weighted least-squares plane through those of its 24 neighbours that hold ξ
// already. ξ keeps its values across periodic sides.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mortise/coupler/reference_map/level_set.hpp"
#include "mortise/coupler/reference_map/solid_point.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

/// Velocity at the cells of a tile, ghosts included: pointers to cell (0, 0), rows as in the field.
struct TileVelocity {
  const double *u, *v;
};

class BodyMap {
 public:
  /// Components of the field: ξ_x, ξ_y, φ(ξ), and the layer: 0 inside, 1 … layers in the band, `unknown` elsewhere.
  static constexpr int components = 4;
  static constexpr int layers = 6;
  static constexpr double unknown = 99;
  /// Cells this far (in either direction) from one inside are on tiles of the map.
  static constexpr int reach = 10;

  using Velocity = std::function<TileVelocity(int tile)>;

  struct Setup {
    std::string name;
    SolidLaw law;
    std::shared_ptr<const LevelSet> level_set;
    std::function<Point<2>(const Point<2>& x)> initial;  // ξ at t = 0 where the body is, and a band around it
  };

  /// `grid` is not owned. Throws InputError when tiles are narrower than 2 · layers cells.
  BodyMap(Setup setup, const ComponentGrid<2>& grid);

  /// False as in drift_to_half(). Collective.
  bool initialize();
  /// The map at t + `time`, from that at t and a velocity that is constant in time; second order in space. False when
  /// det ∂ξ/∂x ≤ 0 somewhere in the body. Collective.
  bool drift_to_half(double time, const Velocity& velocity) { return drift(now_, half_, time, velocity); }
  /// The map at the end of a step from that at its half. Collective.
  bool drift_to_end(double time, const Velocity& velocity) { return drift(half_, now_, time, velocity); }
  /// After field() was replaced from outside: its cells inside the body hold ξ, all others nothing. Collective.
  void resume();

  const std::string& name() const { return setup_.name; }
  const SolidLaw& law() const { return setup_.law; }
  /// At the time of the step's begin, or its end once that is there; and at its half.
  const Field<2>& field() const { return now_; }
  Field<2>& field() { return now_; }
  const Field<2>& half() const { return half_; }
  const LevelSet& level_set() const { return *setup_.level_set; }
  /// Cells of the band that could not be continued from any neighbours, in the last step on this rank.
  std::int64_t orphans() const { return orphans_; }
  std::size_t memory_bytes() const;

 private:
  bool drift(const Field<2>& from, Field<2>& to, double time, const Velocity& velocity);
  void advect_tile(const TileBlock& from, TileBlock& to, const TileVelocity& velocity, double time) const;
  void classify(TileBlock& block) const;
  void fit_tiles(Field<2>& field) const;
  void extend(Field<2>& field);
  void fill_ghosts(Field<2>& field) const;
  bool extend_cell(TileBlock& block, std::size_t cell, double layer) const;
  bool admissible(const Field<2>& field) const;

  Setup setup_;
  const ComponentGrid<2>& grid_;
  Field<2> now_, half_;
  GhostExchange<2> exchange_;
  std::int64_t orphans_ = 0;
};

}  // namespace mortise
