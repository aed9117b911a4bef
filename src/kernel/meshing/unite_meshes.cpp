#include "kernel/meshing/unite_meshes.h"

#include <cmath>
#include <exception>

#ifndef __EMSCRIPTEN__

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <iterator>
#include <utility>
#include <vector>

namespace relievo {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;
using Vertex = Mesh::Vertex_index;
using Sources = Mesh::Property_map<Face, UnitedSource>;

/// Length in units up to which edges are contracted in the first round; four times as long in each
/// further round.
constexpr double shortest_edge = 16;
constexpr int tidy_rounds = 7;

const Error not_united = {ErrorCode::internal, "two solids cannot be united", ""};

Sources sources_of(Mesh& mesh) {
  return mesh.add_property_map<Face, UnitedSource>("f:source", UnitedSource{}).first;
}

/// Passes the sources of faces on to their pieces and copies.
struct SourceKeeper : pmp::Corefinement::Default_visitor<Mesh> {
  void before_subface_creations(Face face, Mesh& mesh) { cut = sources_of(mesh)[face]; }
  void after_subface_created(Face face, Mesh& mesh) { sources_of(mesh)[face] = cut; }
  void after_face_copy(Face from, const Mesh& mesh, Face to, Mesh& copy) {
    sources_of(copy)[to] = mesh.property_map<Face, UnitedSource>("f:source").first[from];
  }
  UnitedSource cut;
};

/// Copies solid `number` into a mesh. Returns false where an edge does not have two triangles.
bool fill(const ClosedMesh& solid, int number, Mesh& mesh) {
  mesh.reserve(static_cast<Mesh::size_type>(solid.points.size()),
               static_cast<Mesh::size_type>(3 * solid.triangles.size() / 2),
               static_cast<Mesh::size_type>(solid.triangles.size()));
  std::vector<Vertex> vertices(solid.points.size(), Mesh::null_vertex());
  const auto vertex = [&](int point) {
    if (vertices[point] == Mesh::null_vertex()) {
      const Point3 p = solid.points[point];
      vertices[point] = mesh.add_vertex({p.x, p.y, p.z});
    }
    return vertices[point];
  };
  Sources sources = sources_of(mesh);
  for (size_t t = 0; t < solid.triangles.size(); ++t) {
    const auto& [p, q, r] = solid.triangles[t];
    const Vertex from = vertex(p);
    const Vertex over = vertex(q);
    const Face face = mesh.add_face(from, over, vertex(r));
    if (face == Mesh::null_face()) return false;
    sources[face] = {number, static_cast<int>(t)};
  }
  return CGAL::is_closed(mesh);
}

/// Marks the points that rounding has moved; points of the solids are not among them.
using Moved = Mesh::Property_map<Vertex, bool>;

Moved round_points(double unit, Mesh& mesh) {
  const Moved moved = mesh.add_property_map<Vertex, bool>("v:moved", false).first;
  const auto on_grid = [unit](double x) { return unit * std::round(x / unit); };
  for (const Vertex v : mesh.vertices()) {
    const Kernel::Point_3 p = mesh.point(v);
    mesh.point(v) = {on_grid(p.x()), on_grid(p.y()), on_grid(p.z())};
    moved[v] = mesh.point(v) != p;
  }
  return moved;
}

/// Contracts the shortest edge of a triangle with a moved end, if it is at most `longest`. Returns
/// whether it did.
bool contract_shortest(Face face, double longest, const Moved& moved, Mesh& mesh) {
  Mesh::Halfedge_index best;
  double least = longest * longest;
  for (const Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(face), mesh)) {
    if (!moved[mesh.source(h)] && !moved[mesh.target(h)]) continue;
    const double squared =
        CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    if (squared > least) continue;
    least = squared;
    best = h;
  }
  if (best == Mesh::null_halfedge()) return false;
  const auto edge = mesh.edge(best);
  if (!CGAL::Euler::does_satisfy_link_condition(edge, mesh)) return false;
  const bool fixed = !moved[mesh.source(best)];
  const Kernel::Point_3 place = mesh.point(fixed ? mesh.source(best) : mesh.target(best));
  const bool free = moved[mesh.source(best)] && moved[mesh.target(best)];
  const Vertex kept = CGAL::Euler::collapse_edge(edge, mesh);
  mesh.point(kept) = place;
  moved[kept] = free;
  return true;
}

/// Contracts edges, along the line where the solids meet, that are too short for the grid, and
/// longer ones where that does not suffice. Returns whether no triangles cross any more.
bool tidy(double unit, const Moved& moved, Mesh& mesh) {
  double longest = shortest_edge * unit;
  std::vector<Face> open(mesh.faces().begin(), mesh.faces().end());
  for (int round = 0; round < tidy_rounds; ++round, longest *= 4) {
    for (const Face face : open)
      while (!mesh.is_removed(face) && contract_shortest(face, longest, moved, mesh)) continue;
    std::vector<std::pair<Face, Face>> crossing;
    pmp::self_intersections(mesh, std::back_inserter(crossing));
    if (crossing.empty()) return true;
    open.clear();
    for (const auto& [one, other] : crossing) open.insert(open.end(), {one, other});
  }
  return false;
}

UnitedMesh read(Mesh& mesh) {
  UnitedMesh united;
  mesh.collect_garbage();
  for (const Vertex v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    united.mesh.points.push_back({p.x(), p.y(), p.z()});
  }
  const Sources sources = sources_of(mesh);
  for (const Face face : mesh.faces()) {
    std::array<int, 3>& triangle = united.mesh.triangles.emplace_back();
    int k = 0;
    for (const Vertex v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      triangle[k++] = static_cast<int>(v.idx());
    united.sources.push_back(sources[face]);
  }
  return united;
}

/// Drops the surfaces that face inwards. Returns the number of those left and the volume that the
/// dropped ones enclosed.
std::pair<int, double> drop_hollows(Mesh& mesh) {
  auto piece = mesh.add_property_map<Face, size_t>("f:piece").first;
  const size_t count = pmp::connected_components(mesh, piece);
  std::vector<double> six(count, 0);
  for (const Face face : mesh.faces()) {
    std::array<Kernel::Point_3, 3> p;
    int k = 0;
    for (const Vertex v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      p[k++] = mesh.point(v);
    six[piece[face]] +=
        CGAL::determinant(p[0] - CGAL::ORIGIN, p[1] - CGAL::ORIGIN, p[2] - CGAL::ORIGIN);
  }
  std::vector<size_t> hollow;
  double filled = 0;
  for (size_t i = 0; i < count; ++i)
    if (!(six[i] > 0)) {
      hollow.push_back(i);
      filled -= six[i] / 6;
    }
  if (!hollow.empty()) pmp::remove_connected_components(mesh, hollow, piece);
  return {static_cast<int>(count - hollow.size()), filled};
}

}  // namespace

Result<UnitedMesh> unite_meshes(const ClosedMesh& first, const ClosedMesh& second, double unit) {
  Mesh a;
  Mesh b;
  if (!fill(first, 0, a) || !fill(second, 1, b)) return not_united;
  Mesh both;
  sources_of(both);
  try {
    const auto strict = CGAL::parameters::throw_on_self_intersection(true);
    if (!pmp::corefine_and_compute_union(a, b, both, strict.visitor(SourceKeeper{}),
                                         CGAL::parameters::all_default()))
      return not_united;
  } catch (const std::exception&) {
    return not_united;
  }
  const Moved moved = round_points(unit, both);
  const auto [pieces, filled] = drop_hollows(both);
  if (!tidy(unit, moved, both)) return not_united;
  UnitedMesh united = read(both);
  united.pieces = pieces;
  united.filled = filled;
  return united;
}

}  // namespace relievo

#else

namespace relievo {

// The page has no use for it, and it would make the download much larger.
Result<UnitedMesh> unite_meshes(const ClosedMesh&, const ClosedMesh&, double) {
  return Error{ErrorCode::usage, "solids cannot be united in the browser", ""};
}

}  // namespace relievo

#endif
