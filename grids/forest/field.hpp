// Data on tiles. A tile is a block of cells with ghost layers; a field keeps one structure-of-arrays block per
// tile: one plane per component, rows contiguous along direction 0, 64-byte aligned, with at least eight doubles
// of slack on each side of a row so that kernels may run whole vectors over the edge.
#pragma once

#include <cstddef>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// Memory shape of every tile of one component grid.
template <int Dim>
struct TileShape {
  static constexpr int ghosts = 2;  // layers around the cells that hold data
  static constexpr int slack = 8;   // doubles before the first cell of a row (the last `ghosts` of them are ghost cells)

  explicit TileShape(Index<Dim> cells_) : cells(cells_) {
    stride = (cells[0] + 2 * slack + 7) / 8 * 8;
    rows = 1;
    if constexpr (Dim == 2) rows = cells[1] + 2 * ghosts;
    plane = static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows);
    if (plane / 8 % 2 == 0) plane += 8;  // an odd number of cache lines, so that planes do not alias
  }

  /// Offset of cell (i, j) in a plane; ghost cells have indices −2, −1 and cells[d], cells[d] + 1.
  std::size_t at(int i, int j = 0) const {
    const int row = Dim == 2 ? j + ghosts : 0;
    return static_cast<std::size_t>(row * stride + i + slack);
  }
  std::size_t at(const Index<Dim>& c) const {
    if constexpr (Dim == 2) return at(c[0], c[1]);
    return at(c[0]);
  }
  int count() const {
    int n = 1;
    for (int d = 0; d < Dim; ++d) n *= cells[d];
    return n;
  }

  Index<Dim> cells;   // cells along each direction, without ghosts; even
  int stride = 0;     // doubles from one row to the next; a multiple of 8
  int rows = 1;       // rows with ghosts (1D: one)
  std::size_t plane;  // doubles from one component to the next
};


/// Component planes of one tile. Owns its memory; may be unallocated (a tile wholly inside a hole).
class TileBlock {
 public:
  TileBlock() = default;
  TileBlock(std::size_t plane, int components) : plane_(plane), components_(components) {
    const std::size_t bytes = (plane * static_cast<std::size_t>(components) * sizeof(double) + 63) / 64 * 64;
    data_.reset(static_cast<double*>(std::aligned_alloc(64, bytes)));
    if (!data_) throw std::bad_alloc();
    std::fill_n(data_.get(), bytes / sizeof(double), 0.0);
  }
  bool allocated() const { return data_ != nullptr; }
  void release() { data_.reset(); }
  double* component(int c) { return data_.get() + static_cast<std::size_t>(c) * plane_; }
  const double* component(int c) const { return data_.get() + static_cast<std::size_t>(c) * plane_; }
  std::span<double> all() { return {data_.get(), allocated() ? plane_ * static_cast<std::size_t>(components_) : 0}; }
  std::size_t bytes() const { return allocated() ? plane_ * static_cast<std::size_t>(components_) * sizeof(double) : 0; }

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double[], Free> data_;
  std::size_t plane_ = 0;
  int components_ = 0;
};

/// One block per local tile of a component grid, in the order of the forest's local tiles.
template <int Dim>
class Field {
 public:
  Field(const TileShape<Dim>& shape, int components, int tiles) : shape_(shape), components_(components) {
    blocks_.resize(static_cast<std::size_t>(tiles));
    for (int t = 0; t < tiles; ++t) allocate(t);
  }
  /// Without memory yet.
  static Field unallocated(const TileShape<Dim>& shape, int components, int tiles) {
    Field field(shape, components, 0);
    field.blocks_.resize(static_cast<std::size_t>(tiles));
    return field;
  }
  const TileShape<Dim>& shape() const { return shape_; }
  int components() const { return components_; }
  int tiles() const { return static_cast<int>(blocks_.size()); }
  TileBlock& tile(int t) { return blocks_[static_cast<std::size_t>(t)]; }
  const TileBlock& tile(int t) const { return blocks_[static_cast<std::size_t>(t)]; }
  void allocate(int t) { tile(t) = TileBlock(shape_.plane, components_); }

 private:
  TileShape<Dim> shape_;
  int components_;
  std::vector<TileBlock> blocks_;
};

}  // namespace mortise
