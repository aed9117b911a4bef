#include "kernel/meshing/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace relievo {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using ConstrainedFaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel, ConstrainedFaceBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

struct CornerFace {
  std::array<int, 3> corners;
  Triangulation::Face_handle face;
};

/// Which corner of a face has the smallest number.
int first_corner(Triangulation::Face_handle face) {
  int first = 0;
  for (int k = 1; k < 3; ++k)
    if (face->vertex(k)->info() < face->vertex(first)->info()) first = k;
  return first;
}

/// All triangles by their corners, smallest first: an order that does not depend on the one in
/// which points were inserted, which differs between standard libraries.
std::vector<CornerFace> sorted_faces(const Triangulation& cdt) {
  std::vector<CornerFace> faces;
  faces.reserve(cdt.number_of_faces());
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    const int first = first_corner(f);
    CornerFace face{{}, f};
    for (int k = 0; k < 3; ++k) face.corners[k] = f->vertex((first + k) % 3)->info();
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end(),
            [](const CornerFace& a, const CornerFace& b) { return a.corners < b.corners; });
  return faces;
}

PlanarTriangulation numbered_triangles(const Triangulation& cdt) {
  const std::vector<CornerFace> faces = sorted_faces(cdt);
  int count = 0;
  for (const CornerFace& face : faces) face.face->info() = count++;
  PlanarTriangulation out;
  out.triangles.reserve(faces.size());
  out.neighbours.reserve(faces.size());
  for (const CornerFace& face : faces) {
    const int first = first_corner(face.face);
    std::array<int, 3> across{};
    for (int k = 0; k < 3; ++k) {
      const Triangulation::Face_handle other = face.face->neighbor((first + k) % 3);
      across[k] = cdt.is_infinite(other) ? -1 : other->info();
    }
    out.triangles.push_back(face.corners);
    out.neighbours.push_back(across);
  }
  return out;
}

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

  return numbered_triangles(cdt);
}

}  // namespace relievo
