#include "support/analytic_discs.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "relief/surface/assemble_model.h"
#include "relief/surface/surface_sample.h"
#include "relievo/model.h"

namespace relievo {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

constexpr double two_pi = 6.283185307179586;

struct CirclePoint {
  double angle = 0;
  Point2 place;
};

double angle_of(const Disc& disc, Point2 p) {
  const double angle = std::atan2(p.y - disc.centre.y, p.x - disc.centre.x);
  return angle < 0 ? angle + two_pi : angle;
}

/// Adds the points where two circles cross to both lists.
void cross_circles(const Disc& a, const Disc& b, std::vector<CirclePoint>& on_a,
                   std::vector<CirclePoint>& on_b) {
  const Point2 axis = b.centre - a.centre;
  const double gap = norm(axis);
  if (gap >= a.radius + b.radius || gap <= std::abs(a.radius - b.radius)) return;
  const double along = (gap * gap + a.radius * a.radius - b.radius * b.radius) / (2 * gap);
  const double half = std::sqrt(a.radius * a.radius - along * along);
  for (const double side : {-1.0, 1.0}) {
    const Point2 p =
        a.centre + (along / gap) * axis + (side * half / gap) * Point2{-axis.y, axis.x};
    on_a.push_back({angle_of(a, p), p});
    on_b.push_back({angle_of(b, p), p});
  }
}

/// A polygon on the circle through all its crossings.
Ring sample_circle(const Disc& disc, std::vector<CirclePoint> fixed, double edge_length) {
  if (fixed.empty()) fixed.push_back({0, disc.centre + Point2{disc.radius, 0}});
  std::sort(fixed.begin(), fixed.end(),
            [](const CirclePoint& a, const CirclePoint& b) { return a.angle < b.angle; });
  Ring ring;
  for (size_t i = 0; i < fixed.size(); ++i) {
    const double begin = fixed[i].angle;
    const double end = i + 1 < fixed.size() ? fixed[i + 1].angle : fixed[0].angle + two_pi;
    const int pieces = std::max(2, static_cast<int>((end - begin) * disc.radius / edge_length));
    ring.push_back(fixed[i].place);
    for (int k = 1; k < pieces; ++k) {
      const double angle = begin + (end - begin) * k / pieces;
      ring.push_back(disc.centre + disc.radius * Point2{std::cos(angle), std::sin(angle)});
    }
  }
  return ring;
}

std::vector<Ring> sample_circles(const std::vector<Disc>& discs, double edge_length) {
  std::vector<std::vector<CirclePoint>> crossings(discs.size());
  for (size_t i = 0; i < discs.size(); ++i)
    for (size_t j = i + 1; j < discs.size(); ++j)
      cross_circles(discs[i], discs[j], crossings[i], crossings[j]);
  std::vector<Ring> rings;
  for (size_t i = 0; i < discs.size(); ++i)
    rings.push_back(sample_circle(discs[i], crossings[i], edge_length));
  return rings;
}

bool well_inside(const std::vector<Disc>& discs, Point2 p, double margin) {
  bool inside = false;
  for (const Disc& disc : discs) {
    const double r = distance(p, disc.centre);
    if (std::abs(r - disc.radius) < margin) return false;
    inside = inside || r < disc.radius;
  }
  return inside;
}

void insert_inner_points(const std::vector<Disc>& discs, double edge_length, Triangulation& cdt) {
  Box2 box;
  for (const Disc& disc : discs) {
    box.add(disc.centre - Point2{disc.radius, disc.radius});
    box.add(disc.centre + Point2{disc.radius, disc.radius});
  }
  const double row_height = 0.866 * edge_length;
  for (int row = 0; box.min.y + row * row_height < box.max.y; ++row)
    for (double x = box.min.x + (row % 2) * 0.5 * edge_length; x < box.max.x; x += edge_length) {
      const Point2 p{x, box.min.y + row * row_height};
      if (well_inside(discs, p, 0.6 * edge_length)) cdt.insert(Kernel::Point_2(p.x, p.y));
    }
}

Point2 to_point(const Triangulation::Vertex_handle& v) { return {v->point().x(), v->point().y()}; }

std::vector<int> parts_over(const std::vector<Ring>& rings, Point2 p) {
  std::vector<int> parts;
  for (size_t i = 0; i < rings.size(); ++i)
    if (winding_number(rings[i], p) != 0) parts.push_back(static_cast<int>(i));
  return parts;
}

void add_base(const Triangulation& cdt, const std::vector<Ring>& rings, relief::LayeredMesh& mesh) {
  std::vector<std::vector<int>> stacks;
  std::map<Triangulation::Face_handle, int> index;
  for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v) {
    v->info() = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(to_point(v));
  }
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    const Point2 sum = to_point(f->vertex(0)) + to_point(f->vertex(1)) + to_point(f->vertex(2));
    std::vector<int> stack = parts_over(rings, (1.0 / 3) * sum);
    if (stack.empty()) continue;
    index[f] = static_cast<int>(mesh.triangles.size());
    mesh.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    stacks.push_back(std::move(stack));
  }
  mesh.neighbours.resize(mesh.triangles.size());
  for (const auto& [handle, t] : index)
    for (int k = 0; k < 3; ++k) {
      const auto other = index.find(handle->neighbor(k));
      mesh.neighbours[t][k] = other == index.end() ? -1 : other->second;
    }
  mesh.stack_begin.push_back(0);
  for (size_t t = 0; t < stacks.size(); ++t) {
    for (const int part : stacks[t]) {
      mesh.face_triangle.push_back(static_cast<int>(t));
      mesh.face_part.push_back(part);
    }
    mesh.stack_begin.push_back(static_cast<int>(mesh.face_part.size()));
  }
}

/// One node for every part and base vertex of its faces.
void add_nodes(const std::vector<Ring>& rings, relief::LayeredMesh& mesh) {
  std::vector<std::vector<int>> node(mesh.part_count, std::vector<int>(mesh.vertices.size(), -1));
  for (size_t f = 0; f < mesh.face_part.size(); ++f) {
    std::array<int, 3> nodes{};
    for (int k = 0; k < 3; ++k) {
      const int vertex = mesh.triangles[mesh.face_triangle[f]][k];
      int& n = node[mesh.face_part[f]][vertex];
      if (n < 0) {
        n = static_cast<int>(mesh.node_vertex.size());
        const Ring& ring = rings[mesh.face_part[f]];
        const bool rim = std::find(ring.begin(), ring.end(), mesh.vertices[vertex]) != ring.end();
        mesh.node_vertex.push_back(vertex);
        mesh.node_part.push_back(mesh.face_part[f]);
        mesh.node_role.push_back(rim ? relief::NodeRole::outline : relief::NodeRole::interior);
      }
      nodes[k] = n;
    }
    mesh.faces.push_back(nodes);
  }
}

void add_node_heights(const std::vector<Disc>& discs, DiscRelief& relief) {
  for (size_t n = 0; n < relief.mesh.node_vertex.size(); ++n) {
    const Disc& disc = discs[relief.mesh.node_part[n]];
    const Point2 p = relief.mesh.vertices[relief.mesh.node_vertex[n]];
    const bool rim = relief.mesh.node_role[n] == relief::NodeRole::outline;
    const double u = rim ? 0 : disc_u(disc, p);
    relief.inflation.u.push_back(u);
    relief.inflation.grad_u.push_back(-2 * disc.d * std::abs(disc.d) * (p - disc.centre));
    relief.ordering.g.push_back(disc_g(disc, p));
    relief.ordering.grad_g.push_back(disc.slope);
    relief.ordering.h.push_back(disc_g(disc, p) + relief::signed_root(u));
  }
}

}  // namespace

double disc_u(const Disc& disc, Point2 p) {
  const Point2 r = p - disc.centre;
  return disc.d * std::abs(disc.d) * (disc.radius * disc.radius - dot(r, r));
}

double disc_g(const Disc& disc, Point2 p) { return disc.lift + dot(disc.slope, p - disc.centre); }

double disc_height(const Disc& disc, Point2 p) {
  return disc_g(disc, p) + relief::signed_root(disc_u(disc, p));
}

DiscRelief make_discs(const std::vector<Disc>& discs, double width, double height,
                      double edge_length) {
  const std::vector<Ring> rings = sample_circles(discs, edge_length);
  Triangulation cdt;
  for (const Ring& ring : rings)
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point2 a = ring[i];
      const Point2 b = ring[(i + 1) % ring.size()];
      cdt.insert_constraint(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y));
    }
  insert_inner_points(discs, edge_length, cdt);
  DiscRelief relief;
  relief.scene.width = width;
  relief.scene.height = height;
  for (size_t i = 0; i < discs.size(); ++i)
    relief.scene.parts.push_back({"disc" + std::to_string(i), {rings[i]}, 4, discs[i].d});
  relief.mesh.part_count = static_cast<int>(discs.size());
  relief.mesh.edge_length = edge_length;
  add_base(cdt, rings, relief.mesh);
  add_nodes(rings, relief.mesh);
  add_node_heights(discs, relief);
  return relief;
}

void set_linear_heights(DiscRelief& relief, LinearField u, LinearField g) {
  for (size_t n = 0; n < relief.mesh.node_vertex.size(); ++n) {
    const Point2 p = relief.mesh.vertices[relief.mesh.node_vertex[n]];
    relief.inflation.u[n] = u.value + dot(u.slope, p);
    relief.inflation.grad_u[n] = u.slope;
    relief.ordering.g[n] = g.value + dot(g.slope, p);
    relief.ordering.grad_g[n] = g.slope;
    relief.ordering.h[n] = relief.ordering.g[n] + relief::signed_root(relief.inflation.u[n]);
  }
}

Model assemble(const DiscRelief& relief, const ModelOptions& options) {
  auto model = relief::assemble_model(
      {relief.mesh, relief.inflation, relief.ordering, relief.scene}, options);
  EXPECT_TRUE(model.ok()) << to_string(model.error());
  return model.ok() ? std::move(*model) : Model{};
}

Model assemble(const DiscRelief& relief, Visibility visibility) {
  ModelOptions options;
  options.visibility = visibility;
  return assemble(relief, options);
}

}  // namespace relievo
