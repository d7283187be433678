// Overlapping grids: which cells of which component grid are advanced, and where the others get their values.
//
// The plane is shared out by distance. Let d_b be the distance from body b and d_w that from the edge of the domain.
// A point belongs to the nearest body if it is closer than the body's grid reaches, otherwise to the background; next to
// the edge of the domain (d_w ≤ d_b) it belongs to the background. Every grid is active on its share and
// `margin` beyond it (body grids against each other), or `overlap` cells (background under a body grid). Cells that an active
// cell's stencil |di| + |dj| ≤ 2 needs and that are not active are the fringe; all others are holes.
//
// Fringe cells, and cells that have become active since the last cut (exposed cells), take values by interpolation,
// biquadratic in the donor's logical coordinates, from donor stencils of active, not exposed cells, clipped to the
// stencil's range. A cell without such a donor is an orphan. Where no such stencil exists (pockets between
// three grids, gaps too narrow for two full stencils) the donor may be clamped to the wall row of the neighbouring body's grid, or
// be a single cell; such cells are counted as `tight`.
//
// Where the domain is periodic, bodies are there once in every period: of all images of a point the one nearest to the body counts.
//
// Everything here is a function of the poses alone, so the answer does not depend on the number of ranks.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mortise/grids/core/parallel.hpp"
#include "mortise/grids/geometry/frame.hpp"
#include "mortise/grids/geometry/line_atlas.hpp"
#include "mortise/grids/overlap/component_grid.hpp"
#include "mortise/grids/overlap/periods.hpp"

namespace mortise {

struct OverlapOptions {
  double overlap = 3;  // cells by which background and body grid are both active
  double margin = 1;   // cells by which the grids of two close bodies are both active on each other's side
  double least_gap = 3;  // cells between bodies, or a body and the edge of the domain, below which orphans may occur
  bool clip = true;      // interpolated values to the range of the donor's stencil: off for smooth fields
};

/// Totals over all ranks since the last cut.
struct OverlapReport {
  std::int64_t fringe = 0;   // interpolated cells
  std::int64_t holes = 0;    // cells neither active nor fringe
  std::int64_t exposed = 0;  // cells that became active at the last cut
  std::int64_t tight = 0;    // fringe or exposed cells with a donor of lower order
  std::int64_t orphans = 0;  // cells without a donor
  std::string first_orphan;  // grid, index and position, when there is one on this rank
};

template <int Dim>
struct OverlapBody {
  std::shared_ptr<const Atlas<Dim>> atlas;
  double spacing = 0;  // of the body's grids, across
  int layers = 0;      // of the body's grids, the outer two of which are fringe
};

/// Options for a body made of a grid within its outline and a Cartesian core, nothing being known outside: the core's
/// fringe, two cells wide, ends at the outline. Full order takes at least 5 layers (three rows that are not fringe).
template <int Dim>
OverlapOptions composite_options(const OverlapBody<Dim>& body, double core_spacing) {
  return {.overlap = std::min(OverlapOptions{}.overlap, body.layers - 2 - 2 * core_spacing / body.spacing), .clip = false};
}

/// Where a value is interpolated from: nine (1D: three) cells around `center` of a local tile.
template <int Dim>
struct Donor {
  int grid = 0, tile = 0;
  std::size_t center = 0;                            // TileShape offset of the stencil's middle cell
  std::array<std::array<double, 3>, Dim> weights{};  // Lagrange weights along each direction
};

/// A local cell that receives a value.
struct Receiver {
  int grid = 0, tile = 0;
  std::size_t cell = 0;  // TileShape offset
};

template <int Dim>
class Overlap {
 public:
  Overlap(const Communicator& comm, std::vector<ComponentGrid<Dim>>& grids, std::vector<OverlapBody<Dim>> bodies, Box<Dim> domain,
          OverlapOptions options);

  /// Cuts holes and finds donors for bodies at `poses`, writing the masks of the grids. `fresh`: all cells hold valid
  /// values (initial state, restart), none counts as exposed. Only tiles near bodies that moved now or at the last call are
  /// touched. Returns false, having done nothing, when there are none. Collective.
  bool update(const std::vector<Pose<Dim>>& poses, bool fresh);

  /// The body's grid has a new shape (deforming bodies; their poses stay the identity): counts as moved at the next
  /// update().
  void reshape(std::size_t body, std::shared_ptr<const Atlas<Dim>> atlas);

  /// Interpolates into fringe and exposed cells. `fields` holds one field per component grid, ghosts of the
  /// donor tiles filled from neighbouring tiles. `decode(U, W)` turns the components of one cell into the variables to interpolate, `encode(W, U)` back. Collective.
  template <int Components, class Decode, class Encode>
  void fill(std::vector<Field<Dim>>& fields, Decode&& decode, Encode&& encode) const;

  /// Values at arbitrary points, decoded; a point inside a body or outside the domain gives NaN. Collective; all ranks pass the
  /// same points and get all values.
  template <int Components, class Decode>
  std::vector<std::array<double, Components>> sample(const std::vector<Field<Dim>>& fields, std::span<const Point<Dim>> points,
                                                     Decode&& decode) const;

  /// Local tiles of a grid that hold donors: their ghost cells must be filled before fill().
  const std::vector<int>& donor_tiles(int grid) const { return donor_tiles_[static_cast<std::size_t>(grid)]; }

  const OverlapReport& report() const { return report_; }
  /// The report with the numbers of fringe and hole cells, which are not kept up from step to step. Collective.
  OverlapReport census() const;
  const std::vector<ComponentGrid<Dim>>& grids() const { return grids_; }

  /// Share of point x that a cell of `grid` stands for when cells of overlapping grids are summed: a smooth partition of unity.
  double share(int grid, const Point<Dim>& x) const;

 private:
  struct Candidate {  // a grid that may hold a donor
    Index<Dim> center{};               // grid-wide index of the middle of its stencil
    std::array<double, Dim> offset{};  // of the point from there, in cells
    std::array<double, Dim> place{};   // the point, in the body's frame
    int grid = -1;
    bool tight = false;                // a donor of lower order will do
  };
  struct Choice {  // a candidate not yet looked at: a body, or −1 for the background
    int body = -1;
    bool tight = false;
  };
  struct Link {  // a cell and its donor on the same rank
    std::size_t cell = 0;
    Donor<Dim> donor;
  };
  struct TileOverlap {                      // of one tile
    std::vector<std::uint8_t> active_before;  // TileMask::active and ::state before the last cut
    std::vector<CellState> state_before;
    std::vector<std::size_t> receivers;     // fringe and exposed cells
    std::vector<Link> links;                // of those with a donor on this rank
    bool recut = false, was_recut = false;  // at this and the last update
    bool alone = false;                     // body grids: cut by nothing but its own outer edge
    int exposed = 0, tight = 0;
    Index<Dim> low{}, high{};               // background: region of inactive cells
  };

  // cut.cpp
  bool note_motion(const std::vector<Pose<Dim>>& poses, bool fresh);
  void cut_background(int grid, bool fresh);
  void cut_body_grid(int grid, bool fresh);
  void cut_by_body(int grid, int tile, std::size_t body, const Point<Dim>& shift, Index<Dim>& low, Index<Dim>& high);
  void begin_cut(int grid, int tile, std::uint8_t active);
  void mark_fringe(int grid, int tile, Index<Dim> low, Index<Dim> high);
  void collect_receivers(int grid, int tile, const Index<Dim>& low, const Index<Dim>& high);
  void measure(std::size_t grid);
  bool touches(std::size_t body, const Box<Dim>& box) const;
  double edge_distance(const Point<Dim>& x) const;
  double distance(std::size_t body, const Point<Dim>& x) const;
  bool reaches(std::size_t body, const Point<Dim>& x) const;
  bool wanted_by_background(const Point<Dim>& x) const;
  bool wanted_by_body(int body, double own_distance, const Point<Dim>& x) const;
  bool covers_background(const OverlapBody<Dim>& body, double distance, double edge) const;
  double inner_reach(const OverlapBody<Dim>& body) const;
  void count();

  // donors.cpp
  void find_donors();
  void list_donor_tiles();
  void find_remote_donors(std::vector<Receiver> open, std::vector<std::vector<Choice>> choices, std::vector<std::size_t> next);
  bool try_local(const Receiver& receiver, const Point<Dim>& x, const std::vector<Choice>& choices, std::size_t& next);
  void list_choices(int own_grid, const Point<Dim>& x, std::vector<Choice>& choices) const;
  bool locate(const Choice& choice, const Point<Dim>& x, Candidate& found) const;
  bool on_background(const Point<Dim>& x, Candidate& found) const;
  Neighbor owner(const Candidate& candidate) const;
  bool accept(const Candidate& request, Donor<Dim>& donor) const;
  bool accept_reduced(const Candidate& request, int tile, const Index<Dim>& middle, Donor<Dim>& donor) const;
  bool stencil_valid(int grid, int tile, const Index<Dim>& center) const;
  bool usable(int grid, int tile, std::size_t cell) const;
  int component(int body, const Point<Dim>& X) const;
  Point<Dim> position(const Receiver& receiver) const;
  void describe_orphan(const Receiver& receiver);

  TileOverlap& tile_of(int grid, int tile) { return tiles_[static_cast<std::size_t>(grid)][static_cast<std::size_t>(tile)]; }
  const TileOverlap& tile_of(int grid, int tile) const {
    return tiles_[static_cast<std::size_t>(grid)][static_cast<std::size_t>(tile)];
  }

  Communicator comm_;
  std::vector<ComponentGrid<Dim>>& grids_;
  std::vector<OverlapBody<Dim>> bodies_;
  Box<Dim> domain_;
  OverlapOptions options_;
  std::array<bool, Dim> periodic_{};
  Periods<Dim> periods_;

  std::vector<Pose<Dim>> poses_;
  std::vector<Frame<Dim>> frames_;
  std::vector<Box<Dim>> reaches_;                      // of the bodies, in space
  std::vector<Box<Dim>> vicinities_;                   // the same without an inward body's far side
  struct Surroundings {
    std::shared_ptr<const Atlas<Dim>> atlas;
    Frame<Dim> frame;
  };
  std::vector<Surroundings> now_, before_;             // per body: at the last update, and at the one before that
  std::vector<Box<Dim>> touched_;                      // per body: where it is and was, if it matters to this update; else empty
  std::vector<std::uint8_t> moved_;                    // per body: at the last update
  std::vector<std::uint8_t> reshaped_;                 // per body: since the last update
  std::vector<std::vector<Point<Dim>>> body_centers_;  // per grid: cell centres in the body's frame (body grids)
  std::vector<std::vector<double>> own_distances_;     // per grid: distance of the cell centres from the own body

  std::vector<std::vector<TileOverlap>> tiles_;        // per grid, tile
  std::vector<Receiver> remote_receivers_;             // with a donor on another rank
  std::vector<std::vector<int>> accepted_;             // per rank: remote receivers served by it, in the order of its donors
  std::vector<std::vector<Donor<Dim>>> donors_;        // per rank: donors on this rank that serve it
  std::vector<std::vector<int>> donor_tiles_;          // per grid
  OverlapReport report_;
};

}  // namespace mortise

#include "mortise/grids/overlap/interpolation.hpp"
