#include "mortise/grids/core/parallel.hpp"

#include <cstring>
#include <numeric>

namespace mortise {

Communicator::Communicator(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

double Communicator::min(double value) const {
  if (size_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MIN, comm_);
  return value;
}

double Communicator::max(double value) const {
  if (size_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return value;
}

std::int64_t Communicator::sum(std::int64_t value) const {
  if (size_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_SUM, comm_);
  return value;
}

bool Communicator::any(bool value) const { return sum(value ? 1 : 0) > 0; }

void Communicator::barrier() const { MPI_Barrier(comm_); }

std::vector<std::byte> Communicator::gather_all_bytes(const std::byte* data, std::size_t size) const {
  const int mine = static_cast<int>(size);
  std::vector<int> counts(static_cast<std::size_t>(size_)), starts(static_cast<std::size_t>(size_));
  MPI_Allgather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
  std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
  std::vector<std::byte> all(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(data, mine, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, comm_);
  return all;
}

std::vector<std::vector<std::byte>> Communicator::exchange_bytes(const std::vector<std::vector<std::byte>>& outgoing) const {
  const auto n = static_cast<std::size_t>(size_);
  std::vector<int> send(n), receive(n), send_at(n), receive_at(n);
  for (std::size_t r = 0; r < n; ++r) send[r] = static_cast<int>(outgoing[r].size());
  MPI_Alltoall(send.data(), 1, MPI_INT, receive.data(), 1, MPI_INT, comm_);
  std::exclusive_scan(send.begin(), send.end(), send_at.begin(), 0);
  std::exclusive_scan(receive.begin(), receive.end(), receive_at.begin(), 0);
  std::vector<std::byte> out(static_cast<std::size_t>(send_at.back() + send.back()));
  std::vector<std::byte> in(static_cast<std::size_t>(receive_at.back() + receive.back()));
  for (std::size_t r = 0; r < n; ++r)
    if (!outgoing[r].empty()) std::memcpy(out.data() + send_at[r], outgoing[r].data(), outgoing[r].size());
  MPI_Alltoallv(out.data(), send.data(), send_at.data(), MPI_BYTE, in.data(), receive.data(), receive_at.data(), MPI_BYTE, comm_);
  std::vector<std::vector<std::byte>> incoming(n);
  for (std::size_t r = 0; r < n; ++r) incoming[r].assign(in.begin() + receive_at[r], in.begin() + receive_at[r] + receive[r]);
  return incoming;
}

void Communicator::copy_bytes(const std::vector<std::byte>& from, void* to) {
  if (!from.empty()) std::memcpy(to, from.data(), from.size());
}

}  // namespace mortise
