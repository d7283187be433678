#include "mortise/grids/geometry/cgal_planar.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace mortise {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

CGAL::Polygon_2<Kernel> cgal_polygon(const std::vector<Point<2>>& vertices) {
  CGAL::Polygon_2<Kernel> polygon;
  for (const Point<2>& v : vertices) polygon.push_back(Kernel::Point_2(v.x(), v.y()));
  return polygon;
}

}  // namespace

bool is_simple_polygon(const std::vector<Point<2>>& vertices) { return cgal_polygon(vertices).is_simple(); }

bool is_counter_clockwise(const std::vector<Point<2>>& vertices) {
  return cgal_polygon(vertices).orientation() == CGAL::COUNTERCLOCKWISE;
}

std::vector<std::pair<int, int>> delaunay_edges(const std::vector<Point<2>>& points) {
  std::vector<std::pair<int, int>> edges;
  Triangulation triangulation;
  Triangulation::Face_handle hint;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(Kernel::Point_2(points[k].x(), points[k].y()), hint);
    if (triangulation.number_of_vertices() == before) {
      edges.emplace_back(vertex->info(), static_cast<int>(k));
    } else {
      vertex->info() = static_cast<int>(k);
    }
    hint = vertex->face();
  }
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
    const auto& [face, opposite] = *edge;
    edges.emplace_back(face->vertex(face->cw(opposite))->info(), face->vertex(face->ccw(opposite))->info());
  }
  return edges;
}

}  // namespace mortise
