// Interpolation from donors: tensor-product quadratics in logical coordinates, third-order accurate, clipped (unless told
// otherwise) to the range of the stencil so that no new extrema appear at shocks. Included by overlap.hpp.
#pragma once

#include <algorithm>
#include <limits>

namespace mortise {

/// Lagrange weights at r of the quadratic through −1, 0, 1.
inline std::array<double, 3> quadratic_weights(double r) { return {0.5 * r * (r - 1), (1 - r) * (1 + r), 0.5 * r * (r + 1)}; }

/// The donor's value in decoded variables.
template <int Components, int Dim, class Decode>
std::array<double, Components> interpolate(const Field<Dim>& field, const Donor<Dim>& donor, Decode&& decode, bool clip = true) {
  constexpr int rows = Dim == 2 ? 3 : 1;
  const TileBlock& block = field.tile(donor.tile);
  const double* data = block.component(0) + donor.center;
  const auto plane = static_cast<std::ptrdiff_t>(field.shape().plane);
  std::array<double, Components> sum{}, low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < 3; ++i) {
      const std::ptrdiff_t cell = i - 1 + (Dim == 2 ? (j - 1) * static_cast<std::ptrdiff_t>(field.shape().stride) : 0);
      double weight = donor.weights[0][static_cast<std::size_t>(i)];
      if constexpr (Dim == 2) weight *= donor.weights[1][static_cast<std::size_t>(j)];
      std::array<double, Components> U, W;
      for (int c = 0; c < Components; ++c) U[static_cast<std::size_t>(c)] = data[c * plane + cell];
      decode(U.data(), W.data());
      for (std::size_t c = 0; c < Components; ++c) {
        sum[c] += weight * W[c];
        low[c] = W[c] < low[c] ? W[c] : low[c];
        high[c] = W[c] > high[c] ? W[c] : high[c];
      }
    }
  if (clip)
    for (std::size_t c = 0; c < Components; ++c) sum[c] = std::clamp(sum[c], low[c], high[c]);
  return sum;
}

template <int Dim>
template <int Components, class Decode, class Encode>
void Overlap<Dim>::fill(std::vector<Field<Dim>>& fields, Decode&& decode, Encode&& encode) const {
  using Value = std::array<double, Components>;
  const auto put = [&](std::size_t grid, int tile, std::size_t cell, const Value& W) {
    Value U;
    encode(W.data(), U.data());
    TileBlock& block = fields[grid].tile(tile);
    for (int c = 0; c < Components; ++c) block.component(c)[cell] = U[static_cast<std::size_t>(c)];
  };
  // Donors are active cells that are not exposed, so none of them is written here: the order does not matter.
  for (std::size_t g = 0; g < tiles_.size(); ++g)
    for (std::size_t t = 0; t < tiles_[g].size(); ++t)
      for (const Link& link : tiles_[g][t].links)
        put(g, static_cast<int>(t), link.cell, interpolate<Components>(fields[static_cast<std::size_t>(link.donor.grid)], link.donor, decode, options_.clip));
  if (comm_.size() == 1) return;
  std::vector<std::vector<Value>> outgoing(donors_.size());
  for (std::size_t r = 0; r < donors_.size(); ++r)
    for (const Donor<Dim>& donor : donors_[r])
      outgoing[r].push_back(interpolate<Components>(fields[static_cast<std::size_t>(donor.grid)], donor, decode, options_.clip));
  const std::vector<std::vector<Value>> incoming = comm_.exchange(outgoing);
  for (std::size_t r = 0; r < incoming.size(); ++r)
    for (std::size_t k = 0; k < incoming[r].size(); ++k) {
      const Receiver& receiver = remote_receivers_[static_cast<std::size_t>(accepted_[r][k])];
      put(static_cast<std::size_t>(receiver.grid), receiver.tile, receiver.cell, incoming[r][k]);
    }
}

template <int Dim>
template <int Components, class Decode>
std::vector<std::array<double, Components>> Overlap<Dim>::sample(const std::vector<Field<Dim>>& fields,
                                                                 std::span<const Point<Dim>> points, Decode&& decode) const {
  struct Found {
    std::array<double, Components> value;
    int point, rank_of_choice;
  };
  std::vector<Found> mine;
  std::vector<Choice> choices;
  for (std::size_t p = 0; p < points.size(); ++p) {
    list_choices(-1, points[p], choices);
    for (std::size_t k = 0; k < choices.size(); ++k) {
      Candidate candidate;
      Donor<Dim> donor;
      if (!locate(choices[k], points[p], candidate) || !accept(candidate, donor)) continue;
      mine.push_back({interpolate<Components>(fields[static_cast<std::size_t>(donor.grid)], donor, decode, options_.clip), static_cast<int>(p),
                      static_cast<int>(k)});
      break;
    }
  }
  std::vector<std::array<double, Components>> values(points.size());
  for (auto& value : values) value.fill(std::numeric_limits<double>::quiet_NaN());
  std::vector<int> best(points.size(), std::numeric_limits<int>::max());
  for (const Found& found : comm_.gather_all(mine)) {
    const auto p = static_cast<std::size_t>(found.point);
    if (found.rank_of_choice >= best[p]) continue;
    best[p] = found.rank_of_choice;
    values[p] = found.value;
  }
  return values;
}

}  // namespace mortise
