#include "mortise/grids/core/row_workspace.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>

namespace mortise {
namespace {

constexpr std::size_t line = 8;  // doubles in a cache line

struct Free {
  void operator()(double* p) const { std::free(p); }
};

double* thread_memory(std::size_t doubles) {
  static thread_local std::unique_ptr<double[], Free> memory;
  static thread_local std::size_t capacity = 0;
  if (capacity < doubles) {
    memory.reset(static_cast<double*>(std::aligned_alloc(line * sizeof(double), doubles * sizeof(double))));
    capacity = memory ? doubles : 0;
    if (!memory) throw std::bad_alloc();
  }
  return memory.get();
}

}  // namespace

RowWorkspace::RowWorkspace(int nx, int count) {
  const auto cells = static_cast<std::size_t>(nx - 2 * row_start);
  stride_ = line + (cells + line - 1) / line * line + line;
  if (stride_ / line % 2 == 0) stride_ += line;  // an odd number of cache lines, so that rows do not alias
  const std::size_t size = stride_ * static_cast<std::size_t>(count);
  double* memory = thread_memory(size);
  std::fill_n(memory, size, 1.0);
  first_ = memory + line - row_start;
}

}  // namespace mortise
