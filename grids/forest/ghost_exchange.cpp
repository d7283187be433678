#include "mortise/grids/forest/ghost_exchange.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <tuple>
#include <vector>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// A rectangle of cells of a plane: where it is read in the sender and written in the receiver.
struct Slab {
  std::size_t from = 0, to = 0;  // offsets in a plane
  int width = 0, rows = 1;       // cells

  std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(rows); }
};

/// The ghost cells on one side of a tile. They are cells shifted by whole tiles: i here is i − offset · n there.
template <int Dim>
Slab slab_on(int side, const TileShape<Dim>& shape) {
  const Index<Dim> offset = offset_of<Dim>(side);
  Index<Dim> here{}, there{}, extent{};
  for (std::size_t d = 0; d < Dim; ++d) {
    const int n = shape.cells[d], layers = TileShape<Dim>::ghosts;
    here[d] = offset[d] < 0 ? -layers : offset[d] * n;
    there[d] = here[d] - offset[d] * n;
    extent[d] = offset[d] == 0 ? n : layers;
  }
  return {shape.at(there), shape.at(here), extent[0], Dim == 2 ? extent[Dim - 1] : 1};
}

/// Rows of `width` cells, from and to rows that are the given strides apart.
void copy_rows(double* to, std::ptrdiff_t to_stride, const double* from, std::ptrdiff_t from_stride, const Slab& slab) {
  if (slab.width == 2) {  // a side: one 16-byte move per row, without a call
    for (int j = 0; j < slab.rows; ++j, to += to_stride, from += from_stride) std::memcpy(to, from, 2 * sizeof(double));
    return;
  }
  const std::size_t bytes = static_cast<std::size_t>(slab.width) * sizeof(double);
  for (int j = 0; j < slab.rows; ++j, to += to_stride, from += from_stride) std::memcpy(to, from, bytes);
}

void fill_rows(double* to, std::ptrdiff_t stride, double value, const Slab& slab) {
  for (int j = 0; j < slab.rows; ++j, to += stride) std::fill_n(to, slab.width, value);
}

/// A slab of a local tile: of the sender in a message that goes out, of the receiver in one that comes in.
struct Piece {
  int tile = 0;
  int side = 0;  // as the receiver sees it
};

/// What goes to and comes from one other rank, in an order both know: by receiving tile, then side.
struct Partner {
  std::vector<Piece> sent, received;
  std::vector<double> out, in;
};

/// A copy between tiles of this rank.
struct Copy {
  int sender = 0;
  int side = 0;
};

}  // namespace

template <int Dim>
struct GhostExchange<Dim>::Plan {
  Plan(const Forest<Dim>& forest, const TileShape<Dim>& shape_, int components_);

  void list_pieces(const Forest<Dim>& forest);
  void size_buffers();
  void start(const Field<Dim>& field, std::span<const double> filler);
  void finish(Field<Dim>& field);
  void copy_into(Field<Dim>& field, int tile, std::span<const double> filler) const;
  void pack(const Field<Dim>& field, Partner& partner, std::span<const double> filler) const;
  void unpack(Field<Dim>& field, const Partner& partner) const;

  Communicator comm;
  TileShape<Dim> shape;
  int components;
  std::array<Slab, offset_count<Dim>> slabs;  // by side
  std::vector<std::size_t> first_copy;        // of each local tile in `copies`; one more entry: their number
  std::vector<Copy> copies;
  std::map<int, Partner> partners;    // by rank
  std::vector<MPI_Request> requests;  // two per partner
};

template <int Dim>
GhostExchange<Dim>::Plan::Plan(const Forest<Dim>& forest, const TileShape<Dim>& shape_, int components_)
    : comm(forest.communicator()), shape(shape_), components(components_) {
  for (int side = 0; side < offset_count<Dim>; ++side)
    slabs[static_cast<std::size_t>(side)] = slab_on<Dim>(side, shape);
  list_pieces(forest);
  size_buffers();
}

template <int Dim>
void GhostExchange<Dim>::Plan::list_pieces(const Forest<Dim>& forest) {
  std::vector<std::tuple<std::int64_t, int, int, int>>
      sent;  // receiving tile (global), side, sender (local), receiving rank
  for (int tile = 0; tile < forest.local_count(); ++tile) {
    first_copy.push_back(copies.size());
    for (int side = 0; side < offset_count<Dim>; ++side) {
      const int opposite = offset_count<Dim> - 1 - side;
      if (side == opposite) continue;
      const Neighbor& beyond = forest.neighbor(tile, offset_of<Dim>(side));
      if (beyond.kind == Neighbor::Kind::boundary) continue;
      if (beyond.rank == comm.rank()) {
        copies.push_back({beyond.local, side});
      } else {
        partners[beyond.rank].received.push_back({tile, side});
        sent.emplace_back(beyond.global, opposite, tile, beyond.rank);
      }
    }
  }
  first_copy.push_back(copies.size());
  std::sort(sent.begin(), sent.end());
  for (const auto& [global, side, tile, rank] : sent) partners[rank].sent.push_back({tile, side});
}

template <int Dim>
void GhostExchange<Dim>::Plan::size_buffers() {
  const auto doubles = [this](const std::vector<Piece>& pieces) {
    std::size_t cells = 0;
    for (const Piece& piece : pieces) cells += slabs[static_cast<std::size_t>(piece.side)].count();
    return cells * static_cast<std::size_t>(components);
  };
  for (auto& [rank, partner] : partners) {
    partner.out.resize(doubles(partner.sent));
    partner.in.resize(doubles(partner.received));
  }
  requests.resize(2 * partners.size());
}

template <int Dim>
void GhostExchange<Dim>::Plan::pack(const Field<Dim>& field, Partner& partner, std::span<const double> filler) const {
  double* out = partner.out.data();
  for (const Piece& piece : partner.sent) {
    const Slab& slab = slabs[static_cast<std::size_t>(piece.side)];
    const TileBlock& block = field.tile(piece.tile);
    for (int c = 0; c < components; ++c, out += slab.count()) {
      if (block.allocated())
        copy_rows(out, slab.width, block.component(c) + slab.from, shape.stride, slab);
      else
        fill_rows(out, slab.width, filler[static_cast<std::size_t>(c)], slab);
    }
  }
}

template <int Dim>
void GhostExchange<Dim>::Plan::unpack(Field<Dim>& field, const Partner& partner) const {
  const double* in = partner.in.data();
  for (const Piece& piece : partner.received) {
    const Slab& slab = slabs[static_cast<std::size_t>(piece.side)];
    TileBlock& block = field.tile(piece.tile);
    for (int c = 0; c < components; ++c, in += slab.count())
      if (block.allocated()) copy_rows(block.component(c) + slab.to, shape.stride, in, slab.width, slab);
  }
}

template <int Dim>
void GhostExchange<Dim>::Plan::copy_into(Field<Dim>& field, int tile, std::span<const double> filler) const {
  TileBlock& here = field.tile(tile);
  if (!here.allocated()) return;
  const auto t = static_cast<std::size_t>(tile);
  for (std::size_t k = first_copy[t]; k < first_copy[t + 1]; ++k) {
    const Slab& slab = slabs[static_cast<std::size_t>(copies[k].side)];
    const TileBlock& there = field.tile(copies[k].sender);
    for (int c = 0; c < components; ++c) {
      if (there.allocated())
        copy_rows(here.component(c) + slab.to, shape.stride, there.component(c) + slab.from, shape.stride, slab);
      else
        fill_rows(here.component(c) + slab.to, shape.stride, filler[static_cast<std::size_t>(c)], slab);
    }
  }
}

/// Posts all messages; those that come in are awaited by finish(), so that local copies run meanwhile.
template <int Dim>
void GhostExchange<Dim>::Plan::start(const Field<Dim>& field, std::span<const double> filler) {
  constexpr int tag = 1;
  MPI_Request* request = requests.data();
  for (auto& [rank, partner] : partners)
    MPI_Irecv(partner.in.data(), static_cast<int>(partner.in.size()), MPI_DOUBLE, rank, tag, comm.raw(), request++);
  for (auto& [rank, partner] : partners) {
    pack(field, partner, filler);
    MPI_Isend(partner.out.data(), static_cast<int>(partner.out.size()), MPI_DOUBLE, rank, tag, comm.raw(), request++);
  }
}

template <int Dim>
void GhostExchange<Dim>::Plan::finish(Field<Dim>& field) {
  if (requests.empty()) return;
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (const auto& [rank, partner] : partners) unpack(field, partner);
}

template <int Dim>
GhostExchange<Dim>::GhostExchange(const Forest<Dim>& forest, const TileShape<Dim>& shape, int components)
    : plan_(std::make_unique<Plan>(forest, shape, components)) {}

template <int Dim>
GhostExchange<Dim>::~GhostExchange() = default;
template <int Dim>
GhostExchange<Dim>::GhostExchange(GhostExchange&&) noexcept = default;
template <int Dim>
GhostExchange<Dim>& GhostExchange<Dim>::operator=(GhostExchange&&) noexcept = default;

template <int Dim>
void GhostExchange<Dim>::fill(Field<Dim>& field, std::span<const double> filler) const {
  MORTISE_ASSERT(field.components() == plan_->components && field.shape().cells == plan_->shape.cells, "another field");
  plan_->start(field, filler);
  for (int tile = 0; tile < field.tiles(); ++tile) plan_->copy_into(field, tile, filler);
  plan_->finish(field);
}

template <int Dim>
void GhostExchange<Dim>::fill(Field<Dim>& field, std::span<const double> filler, std::span<const int> tiles) const {
  MORTISE_ASSERT(field.components() == plan_->components && field.shape().cells == plan_->shape.cells, "another field");
  plan_->start(field, filler);
  for (const int tile : tiles) plan_->copy_into(field, tile, filler);
  plan_->finish(field);
}

template class GhostExchange<1>;
template class GhostExchange<2>;

}  // namespace mortise
