// The reference map of one body on the tiles near it: where the material at a point came from,
//   ξ_t + (v·∇)ξ = 0.
// Inside the body, φ(ξ) < 0, ξ moves with the material. Around it, in a band a few cells wide, it is continued outward
// (map_extension.hpp) once a step; at the half of a step the band has moved with the flow. ξ keeps its values across
// periodic sides.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mortise/coupler/reference_map/level_set.hpp"
#include "mortise/coupler/reference_map/map_field.hpp"
#include "mortise/coupler/reference_map/solid_point.hpp"

namespace mortise {

/// Velocity at the cells of a tile, ghosts included: pointers to cell (0, 0), rows as in the field.
struct TileVelocity {
  const double *u, *v;
};

class BodyMap {
 public:
  using Velocity = std::function<TileVelocity(int tile)>;

  struct Setup {
    std::string name;
    SolidLaw law;
    std::shared_ptr<const LevelSet> level_set;
    std::function<Point<2>(const Point<2>& x)> initial;  // ξ at t = 0 where the body is, and a band around it
    int layers = 6;                                      // of the band
    // A body that keeps its volume: cells whose map says otherwise, det ∂ξ/∂x outside [½, 2], are taken to be wrong.
    bool keeps_volume = false;
  };

  /// `grid` is not owned. Throws InputError when tiles are narrower than reach() cells.
  BodyMap(Setup setup, const ComponentGrid<2>& grid);

  /// False when det ∂ξ/∂x ≤ 0 somewhere in the body. Collective.
  bool initialize();
  /// half() at t + `time` from field() at t and a velocity that is constant in time; second order in space. False as
  /// in initialize(); never for a body that keeps its volume. Collective.
  bool drift_to_half(double time, const Velocity& velocity);
  /// field() at the end of a step from half(). False as in initialize(), for a body that keeps its volume when more
  /// than a quarter of its cells are wrong. Collective.
  bool drift_to_end(double time, const Velocity& velocity);
  /// After field() was replaced from outside: its cells inside the body hold ξ, all others nothing. Collective.
  void resume();

  const std::string& name() const { return setup_.name; }
  int layers() const { return setup_.layers; }
  /// Cells this far (in either direction) from one inside are on tiles of the map.
  int reach() const { return setup_.layers + 1; }
  const SolidLaw& law() const { return setup_.law; }
  /// At the time of the step's begin, or its end once that is there; and at its half, with one layer less.
  const Field<2>& field() const { return now_.tiles(); }
  Field<2>& field() { return now_.tiles(); }
  const Field<2>& half() const { return half_.tiles(); }
  /// The part of a local tile where field() or half() hold anything, ghosts included.
  const TileWindow& window(int tile, bool half) const { return (half ? half_ : now_).window(tile); }
  const LevelSet& level_set() const { return *setup_.level_set; }
  /// Cells of the band that could not be continued from any neighbours, in the last step on this rank.
  std::int64_t orphans() const { return orphans_; }
  /// Two parts of its surface are so close that nothing may be averaged across the gap (map_branches.hpp).
  bool folded() const { return folded_; }
  /// det ∂ξ/∂x of the cells from offset k on, in a tile of field() or half(): by central differences, of a folded body
  /// within one part of it.
  Pack determinant(const TileBlock& tile, std::size_t k) const;
  /// Cells whose map was replaced because it did not keep its volume, over all steps on this rank.
  std::int64_t repaired() const { return repaired_; }
  std::size_t memory_bytes() const { return now_.memory_bytes() + half_.memory_bytes(); }

 private:
  void advect_tile(int tile, const MapField& from, MapField& to, const TileVelocity& velocity, double time,
                   double last_layer) const;
  void classify(TileBlock& block, const TileWindow& window) const;
  void measure(TileBlock& block, const TileWindow& window, double first_layer) const;
  void settle();
  bool repair();
  void continue_band();
  void fill_band(double largest_jump);
  bool jumps() const;
  bool admissible(const MapField& field) const;

  Setup setup_;
  const ComponentGrid<2>& grid_;
  MapField now_, half_;
  GhostExchange<2> exchange_;
  std::int64_t orphans_ = 0, repaired_ = 0;
  bool folded_ = false;
};

}  // namespace mortise
