#include "mortise/coupler/curve_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mortise {
namespace {

/// Place of the point at fraction r ∈ [0, 1] of a face, the nodes being about equally spaced.
CurveParameters::Place place_on(std::size_t face, double r, std::size_t nodes, bool periodic) {
  CurveParameters::Place place;
  if (r == 0 || r == 1) {
    place.node.fill(r == 0 ? face : (face + 1) % nodes);
    place.weight = {1, 0, 0, 0};
    return place;
  }
  const auto first = static_cast<std::ptrdiff_t>(face) - 1;
  const auto n = static_cast<std::ptrdiff_t>(nodes);
  const std::ptrdiff_t start = periodic ? first : std::clamp<std::ptrdiff_t>(first, 0, std::max<std::ptrdiff_t>(0, n - 4));
  const double t = r + static_cast<double>(static_cast<std::ptrdiff_t>(face) - start);  // in faces from the first node
  for (std::size_t k = 0; k < 4; ++k) {
    place.node[k] = static_cast<std::size_t>(((start + static_cast<std::ptrdiff_t>(k)) % n + n) % n);
    double weight = 1;
    for (std::size_t l = 0; l < 4; ++l)
      if (l != k) weight *= (t - static_cast<double>(l)) / (static_cast<double>(k) - static_cast<double>(l));
    place.weight[k] = weight;
  }
  return place;
}

struct Nearest {
  std::size_t face = 0;
  double fraction = 0, distance = std::numeric_limits<double>::infinity();
};

}  // namespace

CurveParameters curve_parameters(const std::vector<Point<2>>& structure, bool periodic, const Point<2>& period, const std::vector<Point<2>>& fluid,
                                 bool fluid_periodic) {
  CurveParameters out;
  const std::size_t faces = periodic ? structure.size() : structure.size() - 1;
  const auto node = [&](std::size_t k) { return k < structure.size() ? structure[k] : Point<2>(structure[k - structure.size()] + period); };
  out.structure.push_back(0);
  for (std::size_t k = 0; k < faces; ++k) {
    out.lengths.push_back((node(k + 1) - node(k)).norm());
    out.structure.push_back(out.structure.back() + out.lengths.back());
  }
  const double range = out.structure.back();
  const auto nearest_on = [&](const Point<2>& x) {
    Nearest best;
    for (std::size_t k = 0; k < faces; ++k)
      for (const double shift : {-1.0, 0.0, 1.0}) {
        if (shift != 0 && period.isZero()) continue;
        const Point<2> a = node(k) + shift * period, edge = node(k + 1) - node(k);
        double r = std::clamp((x - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        if (r < 1e-9) r = 0;
        if (r > 1 - 1e-9) r = 1;
        const double distance = (x - a - r * edge).norm();
        if (distance < best.distance * (1 - 1e-9)) best = {k, r, distance};
      }
    return best;
  };
  for (const Point<2>& x : fluid) {
    const Nearest on = nearest_on(x);
    out.farthest = std::max(out.farthest, on.distance);
    out.places.push_back(place_on(on.face, on.fraction, structure.size(), periodic));
    out.fluid.push_back(out.structure[on.face] + on.fraction * out.lengths[on.face]);
  }
  if (periodic)  // made monotone: the fluid's nodes run against the structure's
    for (std::size_t k = 1; k < out.fluid.size(); ++k)
      while (out.fluid[k] >= out.fluid[k - 1]) out.fluid[k] -= range;
  if (fluid_periodic) out.fluid.push_back(out.fluid.front() - range);
  return out;
}

}  // namespace mortise
