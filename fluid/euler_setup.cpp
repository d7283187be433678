// The component grids of a scene and the memory on them.
#include <algorithm>

#include "mortise/fluid/euler_solver.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Cells per tile along the surface of a body grid: the whole way round, or an even part of it no longer than 128.
int tile_length(int along) {
  for (int parts = 1; parts < along; ++parts)
    if (along % parts == 0 && along / parts <= 128 && along / parts % 2 == 0) return along / parts;
  throw InputError("a body grid has an even number of cells along the body, not " + std::to_string(along));
}

/// Layers per tile of a mesh: all, or the largest part of them between 16 and 64, if there is one.
int tile_depth(int layers) {
  for (int parts = 1; layers / parts >= 16; ++parts)
    if (layers % parts == 0 && layers / parts <= 64) return layers / parts;
  return layers;
}

void append_body_grids(std::vector<ComponentGrid<2>>& grids, const Communicator& comm, const FittedBody<2>& body, int index) {
  const int along = body.shape.atlas->grid().along;
  const int layers = body.shape.layers;
  grids.emplace_back(body.name, comm, Index<2>{along, layers}, std::array<bool, 2>{true, false}, TileShape<2>({tile_length(along), layers}));
  grids.back().body = index;
  grids.back().spacing.setConstant(body.shape.spacing);
}

void append_body_grids(std::vector<ComponentGrid<1>>& grids, const Communicator& comm, const FittedBody<1>& body, int index) {
  for (const int side : {-1, 1}) {
    if (!std::isfinite(side < 0 ? body.shape.atlas->left() : body.shape.atlas->right())) continue;
    grids.emplace_back(body.name + (side < 0 ? "_left" : "_right"), comm, Index<1>{body.shape.layers}, std::array<bool, 1>{false},
                       TileShape<1>({body.shape.layers}));
    grids.back().body = index;
    grids.back().side = side;
    grids.back().spacing.setConstant(body.shape.spacing);
  }
}

/// The mesh of a body in a scene without background; bodies without one have no gas around them.
void append_mesh(std::vector<ComponentGrid<2>>& grids, const Communicator& comm, const FittedBody<2>& body, Index<2> tile, int index) {
  if (!body.mesh) return;
  const GrownGrid& mesh = *body.mesh;
  for (const std::size_t side : {0, 1})
    if (mesh.periodic != (body.sides[side] == BoundaryKind::periodic))
      throw InputError("the mesh of body " + body.name + " is " + (mesh.periodic ? "" : "not ") + "periodic, unlike its sides");
  if (body.sides[3] == BoundaryKind::periodic) throw InputError("the outer side of the mesh of body " + body.name + " cannot be periodic");
  if (tile[0] == 0) tile = {tile_length(mesh.along), tile_depth(mesh.layers)};
  if (mesh.along % tile[0] != 0 || mesh.layers % tile[1] != 0)
    throw InputError("a mesh of " + std::to_string(mesh.along) + " × " + std::to_string(mesh.layers) + " cells cannot be cut into tiles of " +
                     std::to_string(tile[0]) + " × " + std::to_string(tile[1]));
  grids.emplace_back(body.name, comm, Index<2>{mesh.along, mesh.layers}, std::array<bool, 2>{mesh.periodic, false}, TileShape<2>(tile));
  grids.back().body = index;
  grids.back().spacing.setConstant(mesh.spacing);
}

void append_mesh(std::vector<ComponentGrid<1>>&, const Communicator&, const FittedBody<1>& body, Index<1>, int) {
  throw InputError("body " + body.name + " lies in no gas: on a line there is always a background");
}

}  // namespace

template <int Dim>
EulerSolver<Dim>::EulerSolver(const Communicator& comm, EulerSetup<Dim> setup, PhaseTimers& timers)
    : comm_(comm), setup_(std::move(setup)), timers_(timers) {
  if (has_background()) append_background();
  for (std::size_t b = 0; b < setup_.bodies.size(); ++b)
    has_background() ? append_body_grids(grids_, comm_, setup_.bodies[b], static_cast<int>(b))
                     : append_mesh(grids_, comm_, setup_.bodies[b], setup_.tile, static_cast<int>(b));
  for (ComponentGrid<Dim>& grid : grids_) {
    const int tiles = grid.forest.local_count();
    for (TileMask& mask : grid.masks) mask.active_count = grid.shape.count();
    now_.emplace_back(grid.shape, components, tiles);
    next_.emplace_back(grid.shape, components, tiles);
    exchanges_.emplace_back(grid.forest, grid.shape, components);
    rates_.emplace_back(static_cast<std::size_t>(tiles), 0.0);
    uniform_.emplace_back(static_cast<std::size_t>(tiles), std::uint8_t{0});
    computed_.emplace_back(static_cast<std::size_t>(tiles), std::uint8_t{0});
  }
  new_rates_ = rates_;
  poses_.resize(setup_.bodies.size());
  build_reference_nodes();
  if (!has_background()) return;
  std::vector<OverlapBody<Dim>> shapes;
  for (const FittedBody<Dim>& body : setup_.bodies) shapes.push_back(body.shape);
  overlap_ = std::make_unique<Overlap<Dim>>(comm_, grids_, std::move(shapes), setup_.domain, setup_.overlap);
}

template <int Dim>
void EulerSolver<Dim>::append_background() {
  std::array<bool, Dim> periodic{};
  for (std::size_t d = 0; d < Dim; ++d) {
    periodic[d] = setup_.boundaries.kind[2 * d] == BoundaryKind::periodic;
    if (setup_.cells[d] % setup_.tile[d] != 0)
      throw InputError("a background of " + std::to_string(setup_.cells[d]) + " cells cannot be cut into tiles of " + std::to_string(setup_.tile[d]));
  }
  grids_.emplace_back("background", comm_, setup_.cells, periodic, TileShape<Dim>(setup_.tile));
  grids_[0].origin = setup_.domain.low;
  for (int d = 0; d < Dim; ++d)
    grids_[0].spacing[d] = (setup_.domain.high[d] - setup_.domain.low[d]) / setup_.cells[static_cast<std::size_t>(d)];
}

template class EulerSolver<1>;
template class EulerSolver<2>;

}  // namespace mortise
