#include "kernel/meshing/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

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

constexpr int steps_between_looks = 4096;

/// A face with its corners, the smallest first.
struct CornerFace {
  std::array<int, 3> corners;
  Triangulation::Face_handle face;
};

/// Returns the corner of a face with the smallest number.
int first_corner(Triangulation::Face_handle face) {
  int first = 0;
  for (int k = 1; k < 3; ++k)
    if (face->vertex(k)->info() < face->vertex(first)->info()) first = k;
  return first;
}

/// Sorts all triangles by their corners. This order does not depend on the one in which points were
/// inserted, which differs between standard libraries.
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

/// Inserts the points along a space-filling curve. Returns the vertex of each, null where another
/// point coincides with it or `context` was cancelled before.
std::vector<Triangulation::Vertex_handle> insert_points(const std::vector<Point2>& points,
                                                        Triangulation& cdt,
                                                        const RunContext& context) {
  std::vector<std::pair<Kernel::Point_2, int>> numbered;
  numbered.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(Kernel::Point_2(points[i].x, points[i].y), static_cast<int>(i));
  using Position = CGAL::First_of_pair_property_map<std::pair<Kernel::Point_2, int>>;
  CGAL::spatial_sort(numbered.begin(), numbered.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Position>());
  std::vector<Triangulation::Vertex_handle> handles(points.size());
  Triangulation::Face_handle near;
  int steps = 0;
  for (const auto& [position, number] : numbered) {
    if (++steps % steps_between_looks == 0 && context.cancelled()) break;
    const size_t before = cdt.number_of_vertices();
    const Triangulation::Vertex_handle vertex = cdt.insert(position, near);
    near = vertex->face();
    if (cdt.number_of_vertices() == before) continue;
    vertex->info() = number;
    handles[number] = vertex;
  }
  return handles;
}

}  // namespace

Result<PlanarTriangulation> triangulate(const std::vector<Point2>& points,
                                        const std::vector<std::array<int, 2>>& edges,
                                        const RunContext& context) {
  Triangulation cdt;
  std::vector<Triangulation::Vertex_handle> handles = insert_points(points, cdt, context);
  int steps = 0;
  for (const auto& [a, b] : edges) {
    if (++steps % steps_between_looks == 0 && context.cancelled()) break;
    if (handles[a] == nullptr || handles[b] == nullptr) break;
    cdt.insert_constraint(handles[a], handles[b]);
  }
  if (context.cancelled()) return interrupted_error();
  if (std::count(handles.begin(), handles.end(), nullptr) > 0)
    return Error{ErrorCode::internal, "two points of the triangulation coincide", ""};
  if (cdt.number_of_vertices() != points.size())
    return Error{ErrorCode::internal, "constraints of the triangulation cross", ""};

  return numbered_triangles(cdt);
}

int orientation(Point2 a, Point2 b, Point2 c) {
  using P = Kernel::Point_2;
  return static_cast<int>(CGAL::orientation(P(a.x, a.y), P(b.x, b.y), P(c.x, c.y)));
}

}  // namespace relievo
