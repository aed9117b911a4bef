#include "kernel/meshing/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

namespace relievo {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using ConstrainedFaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel, ConstrainedFaceBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

}  // namespace

Result<PlanarTriangulation> triangulate(const std::vector<Point2>& points,
                                        const std::vector<std::array<int, 2>>& edges) {
  std::vector<std::pair<Kernel::Point_2, int>> numbered;
  numbered.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(Kernel::Point_2(points[i].x, points[i].y), static_cast<int>(i));
  Triangulation cdt;
  cdt.insert(numbered.begin(), numbered.end());
  std::vector<Triangulation::Vertex_handle> handles(points.size());
  for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v)
    handles[v->info()] = v;
  for (const auto& [a, b] : edges) {
    if (handles[a] == nullptr || handles[b] == nullptr)
      return Error{ErrorCode::internal, "two points of the triangulation coincide", ""};
    cdt.insert_constraint(handles[a], handles[b]);
  }
  if (cdt.number_of_vertices() != points.size())
    return Error{ErrorCode::internal, "constraints of the triangulation cross", ""};

  PlanarTriangulation out;
  int count = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) f->info() = count++;
  out.triangles.reserve(count);
  out.neighbours.reserve(count);
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    std::array<int, 3> corners{};
    std::array<int, 3> across{};
    for (int k = 0; k < 3; ++k) {
      corners[k] = f->vertex(k)->info();
      across[k] = cdt.is_infinite(f->neighbor(k)) ? -1 : f->neighbor(k)->info();
    }
    out.triangles.push_back(corners);
    out.neighbours.push_back(across);
  }
  return out;
}

}  // namespace relievo
