#include "mortise/coupler/interface.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {

namespace {

constexpr double coincide = 1e-10;  // nodes nearer than this part of the range are one node

/// The part of the curve that one face takes, low < high.
struct Interval {
  double low, high;
  int face;
};

/// Faces in the order of ascending parameter.
std::vector<Interval> ascending(std::span<const double> nodes, const char* side) {
  if (nodes.size() < 2) throw InputError(std::string("the ") + side + " has no face on the interface");
  const std::size_t faces = nodes.size() - 1;
  const bool rising = nodes.back() > nodes.front();
  std::vector<Interval> intervals(faces);
  for (std::size_t i = 0; i < faces; ++i) {
    const double low = nodes[rising ? i : i + 1], high = nodes[rising ? i + 1 : i];
    if (!(low < high))
      throw InputError(std::string("nodes of the ") + side + " on the interface are not monotone at face " +
                       std::to_string(i));
    intervals[rising ? i : faces - 1 - i] = {low, high, static_cast<int>(i)};
  }
  return intervals;
}

/// The same faces once more, so that all of [start, start + range] is covered whatever node comes first.
std::vector<Interval> unrolled(const std::vector<Interval>& faces, double start, double range) {
  const double shift = range * std::floor((start - faces.front().low) / range);
  std::vector<Interval> twice;
  for (const int turn : {0, 1, 2})
    for (const Interval& face : faces)
      twice.push_back({face.low + shift + turn * range, face.high + shift + turn * range, face.face});
  return twice;
}

/// Moves the ends of `faces` onto the nodes of `onto` where they coincide.
void snap(std::vector<Interval>& faces, const std::vector<Interval>& onto, double tolerance) {
  const auto snapped = [&](double s) {
    const auto next = std::lower_bound(onto.begin(), onto.end(), s - tolerance,
                                       [](const Interval& face, double value) { return face.low < value; });
    const double node = next == onto.end() ? onto.back().high : next->low;
    return std::abs(node - s) <= tolerance ? node : s;
  };
  for (Interval& face : faces) face = {snapped(face.low), snapped(face.high), face.face};
}

/// Lengths of all common parts, in of_structure, to be made shares.
std::vector<Transfer::Piece> common_parts(const std::vector<Interval>& structure, const std::vector<Interval>& fluid) {
  std::vector<Transfer::Piece> pieces;
  for (std::size_t i = 0, j = 0; i < structure.size() && j < fluid.size();) {
    const double low = std::max(structure[i].low, fluid[j].low), high = std::min(structure[i].high, fluid[j].high);
    if (low < high) pieces.push_back({structure[i].face, fluid[j].face, high - low, high - low});
    const bool both = structure[i].high == fluid[j].high, structure_ends = structure[i].high < fluid[j].high;
    if (both || structure_ends) ++i;
    if (both || !structure_ends) ++j;
  }
  return pieces;
}

}  // namespace

Transfer::Transfer(std::span<const double> structure_nodes, std::span<const double> fluid_nodes, bool periodic)
    : structure_faces_(static_cast<int>(structure_nodes.size()) - 1),
      fluid_faces_(static_cast<int>(fluid_nodes.size()) - 1) {
  std::vector<Interval> structure = ascending(structure_nodes, "structure"), fluid = ascending(fluid_nodes, "fluid");
  const double start = structure.front().low, range = structure.back().high - start, tolerance = coincide * range;
  const double fluid_range = fluid.back().high - fluid.front().low;
  if (!(std::abs(fluid_range - range) <= tolerance))
    throw InputError("the two sides of the interface differ in length: structure " + std::to_string(range) +
                     ", fluid " + std::to_string(fluid_range));
  if (periodic)
    fluid = unrolled(fluid, start, range);
  else if (!(std::abs(fluid.front().low - start) <= tolerance))
    throw InputError("the two sides of the interface start at different places: structure " + std::to_string(start) +
                     ", fluid " + std::to_string(fluid.front().low));
  snap(fluid, structure, tolerance);
  pieces_ = common_parts(structure, fluid);

  // Shares of the sum of a face's parts, not of its own length: they sum to 1, and a lone part is exactly 1.
  std::vector<double> of_structure(structure.size()), of_fluid(fluid_nodes.size() - 1);
  for (const Piece& piece : pieces_) {
    of_structure[static_cast<std::size_t>(piece.structure)] += piece.of_structure;
    of_fluid[static_cast<std::size_t>(piece.fluid)] += piece.of_fluid;
  }
  for (Piece& piece : pieces_) {
    piece.of_structure /= of_structure[static_cast<std::size_t>(piece.structure)];
    piece.of_fluid /= of_fluid[static_cast<std::size_t>(piece.fluid)];
  }
  matching_ = pieces_.size() == of_structure.size() && pieces_.size() == of_fluid.size();
}

}  // namespace mortise
