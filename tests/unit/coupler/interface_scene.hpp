// Interfaces in the plane with both sides made up, for tests of the schemes.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "mortise/coupler/schemes.hpp"

namespace mortise::testing {

/// Data of both sides, owned.
struct InterfaceScene {
  std::vector<StructureTrace> structure;
  std::vector<FluidTrace> fluid;
  std::vector<Point<2>> area;
  std::vector<double> reference_length;
  Transfer transfer;
  WallLaw law;

  InterfaceProblem problem() const { return {structure, fluid, area, reference_length, &transfer, &law}; }
  InterfaceSolution solve(const std::string& scheme, const InterfaceOptions& options = {},
                          const InterfaceHistory& history = {}) const {
    return interface_schemes().at(scheme)(problem(), history, options);
  }
  /// Σ (p − p_e) S of the fluid's faces, Σ −t L of the structure's.
  Point<2> fluid_force(const std::vector<double>& pressure, double reference_pressure) const {
    Point<2> force = Point<2>::Zero();
    for (std::size_t b = 0; b < area.size(); ++b) force += (pressure[b] - reference_pressure) * area[b];
    return force;
  }
  Point<2> structure_force(const std::vector<Point<2>>& traction) const {
    Point<2> force = Point<2>::Zero();
    for (std::size_t i = 0; i < traction.size(); ++i) force -= traction[i] * reference_length[i];
    return force;
  }
};

/// Z⁻¹ of an isotropic solid: n⊗n/z_p + t⊗t/z_s.
inline Eigen::Matrix2d isotropic_admittance(const Point<2>& n, double z_p, double z_s) {
  const Point<2> t(-n[1], n[0]);
  return n * n.transpose() / z_p + t * t.transpose() / z_s;
}

/// `faces` + 1 parameters from 0 to length.
inline std::vector<double> even_nodes(int faces, double length) {
  std::vector<double> nodes;
  for (int i = 0; i <= faces; ++i) nodes.push_back(length * i / faces);
  return nodes;
}

/// One face on each side, unit area along n.
inline InterfaceScene one_face(const Point<2>& n, const StructureTrace& structure, const FluidTrace& fluid,
                               const WallLaw& law, double ratio = 1) {
  const std::vector<double> nodes = {0, 1};
  return {{structure}, {fluid}, {ratio * n}, {1.0}, Transfer(nodes, nodes, false), law};
}

/// A stretched arc or closed circle of reference length 2π·turns, structure faces × fluid faces, smooth uneven data.
inline InterfaceScene curve(int structure_faces, int fluid_faces, bool closed, double impedance, const WallLaw& law,
                            double shift = 0) {
  const double length = 2 * std::numbers::pi * (closed ? 1 : 0.4);
  std::vector<double> s = even_nodes(structure_faces, length), f = even_nodes(fluid_faces, length);
  for (double& node : f) node += shift;
  const auto point = [](double angle) { return Point<2>(1.2 * std::cos(angle), 0.9 * std::sin(angle)); };
  InterfaceScene scene{{}, {}, {}, {}, Transfer(s, f, closed), law};
  for (int i = 0; i < structure_faces; ++i) {
    const double at = 0.5 * (s[std::size_t(i)] + s[std::size_t(i) + 1]);
    const Point<2> N(std::cos(at), std::sin(at));
    scene.structure.push_back({{0.1 * std::sin(2 * at), 0.05 + 0.1 * std::cos(at)},
                               0.1 * std::cos(3 * at) * N + Point<2>(0.02, 0.03),
                               isotropic_admittance(N, impedance, 0.5 * impedance)});
    scene.reference_length.push_back(s[std::size_t(i) + 1] - s[std::size_t(i)]);
  }
  for (int b = 0; b < fluid_faces; ++b) {
    const double low = f[std::size_t(b)], high = f[std::size_t(b) + 1], at = 0.5 * (low + high);
    const Point<2> edge = point(high) - point(low);
    scene.area.push_back({edge[1], -edge[0]});
    scene.fluid.push_back({1 + 0.2 * std::sin(at), {0.2 * std::cos(at), -0.1}, 1 + 0.3 * std::cos(2 * at)});
  }
  return scene;
}

}  // namespace mortise::testing
