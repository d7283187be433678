// The few collective operations mortise needs, over the ranks of one MPI communicator. Every result is
// independent of the number of ranks: minima and maxima are exact, and nothing is summed in rank order.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace mortise {

class Communicator {
 public:
  explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

  MPI_Comm raw() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }

  double min(double value) const;
  double max(double value) const;
  std::int64_t sum(std::int64_t value) const;
  bool any(bool value) const;
  void barrier() const;

  /// Concatenation over ranks, in rank order, of each rank's items; every rank gets the whole.
  template <class T>
  std::vector<T> gather_all(const std::vector<T>& mine) const {
    static_assert(std::is_trivially_copyable_v<T>);
    if (size_ == 1) return mine;
    const std::vector<std::byte> all = gather_all_bytes(reinterpret_cast<const std::byte*>(mine.data()), mine.size() * sizeof(T));
    std::vector<T> items(all.size() / sizeof(T));
    copy_bytes(all, items.data());
    return items;
  }

  /// outgoing[r] goes to rank r; returns what each rank sent here, incoming[r] from rank r.
  template <class T>
  std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>>& outgoing) const {
    static_assert(std::is_trivially_copyable_v<T>);
    if (size_ == 1) return outgoing;
    std::vector<std::vector<std::byte>> raw_out(outgoing.size());
    for (std::size_t r = 0; r < outgoing.size(); ++r) {
      const auto* first = reinterpret_cast<const std::byte*>(outgoing[r].data());
      raw_out[r].assign(first, first + outgoing[r].size() * sizeof(T));
    }
    const auto raw_in = exchange_bytes(raw_out);
    std::vector<std::vector<T>> incoming(raw_in.size());
    for (std::size_t r = 0; r < raw_in.size(); ++r) {
      incoming[r].resize(raw_in[r].size() / sizeof(T));
      copy_bytes(raw_in[r], incoming[r].data());
    }
    return incoming;
  }

 private:
  std::vector<std::byte> gather_all_bytes(const std::byte* data, std::size_t size) const;
  std::vector<std::vector<std::byte>> exchange_bytes(const std::vector<std::vector<std::byte>>& outgoing) const;
  static void copy_bytes(const std::vector<std::byte>& from, void* to);

  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};

}  // namespace mortise
