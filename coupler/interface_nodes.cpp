#include "mortise/coupler/interface_nodes.hpp"

namespace mortise {

std::vector<Point<2>> node_velocities(std::span<const Point<2>> of_faces, bool periodic) {
  const auto faces = static_cast<int>(of_faces.size());
  const auto at = [&](int i) -> Point<2> {
    if (periodic) return of_faces[static_cast<std::size_t>(((i % faces) + faces) % faces)];
    if (i >= 0 && i < faces) return of_faces[static_cast<std::size_t>(i)];
    if (faces == 1) return of_faces[0];
    const bool below = i < 0;
    const Point<2>& end = below ? of_faces.front() : of_faces.back();
    const Point<2>& inner = below ? of_faces[1] : of_faces[of_faces.size() - 2];
    return end + (below ? -i : i - faces + 1) * (end - inner);
  };
  std::vector<Point<2>> nodes;
  for (int node = 0; node < faces + (periodic ? 0 : 1); ++node)
    nodes.push_back((at(node - 2) + at(node + 1) + 3 * (at(node - 1) + at(node))) / 8);
  return nodes;
}

std::vector<Point<2>> wrinkle_correction(const InterfaceCurve& curve, std::span<const Point<2>> displacement,
                                         std::span<const Point<2>> tangents, double strength) {
  const std::size_t faces = curve.faces(), nodes = curve.nodes.size();
  std::vector<Point<2>> stretch(faces), defect(faces);  // of the faces' edges: as they are, and less what F says
  for (std::size_t f = 0; f < faces; ++f) {
    const std::size_t next = (f + 1) % nodes;
    const Point<2> edge = curve.nodes[next] + (f + 1 == nodes ? curve.period : Point<2>::Zero()) - curve.nodes[f];
    stretch[f] = displacement[next] - displacement[f];
    defect[f] = edge + stretch[f] - edge.norm() * tangents[f];
  }
  std::vector<Point<2>> change(nodes, Point<2>::Zero());
  for (std::size_t k = curve.periodic ? 0 : 1; k < faces; ++k) {
    const std::size_t before = (k + faces - 1) % faces;
    if (!tangents[before].isZero(0) && !tangents[k].isZero(0)) {
      change[k] = strength * (defect[k] - defect[before]);
    } else if (curve.periodic || (k > 1 && k + 1 < faces)) {
      const Point<2>&far = stretch[(k + 1) % faces], &near = stretch[(before + faces - 1) % faces];
      change[k] = -0.25 * strength * ((far - near) - 3 * (stretch[k] - stretch[before]));
    }
  }
  return change;
}

}  // namespace mortise
