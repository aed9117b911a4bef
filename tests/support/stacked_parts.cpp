#include "support/stacked_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace relievo::testing {
namespace {

using Edge = std::array<int, 2>;

Edge edge_of(const std::array<int, 3>& triangle, int opposite) {
  const int a = triangle[(opposite + 1) % 3];
  const int b = triangle[(opposite + 2) % 3];
  return {std::min(a, b), std::max(a, b)};
}

void link_neighbours(relief::LayeredMesh& mesh) {
  std::map<Edge, std::array<int, 2>> open;
  mesh.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [place, is_new] = open.insert({edge_of(mesh.triangles[t], k), {t, k}});
      if (is_new) continue;
      const auto [other, corner] = place->second;
      mesh.neighbours[t][k] = other;
      mesh.neighbours[other][corner] = t;
    }
}

/// Base vertices on the boundary of the triangles marked.
std::set<int> rim_of(const relief::LayeredMesh& mesh, const std::vector<bool>& covered) {
  std::set<int> rim;
  for (size_t t = 0; t < covered.size(); ++t)
    for (int k = 0; k < 3 && covered[t]; ++k) {
      const int across = mesh.neighbours[t][k];
      if (across >= 0 && covered[across]) continue;
      rim.insert(mesh.triangles[t][(k + 1) % 3]);
      rim.insert(mesh.triangles[t][(k + 2) % 3]);
    }
  return rim;
}

std::vector<bool> covered_triangles(const PlanarMesh& base, const Cover& part) {
  std::vector<bool> covered;
  for (size_t t = 0; t < base.triangles.size(); ++t) {
    const auto& [a, b, c] = base.triangles[t];
    covered.push_back(part(static_cast<int>(t),
                           (1.0 / 3) * (base.vertices[a] + base.vertices[b] + base.vertices[c])));
  }
  return covered;
}

bool is_outline(const relief::LayeredMesh& mesh, int node) {
  return mesh.node_role[node] == relief::NodeRole::outline ||
         mesh.node_role[node] == relief::NodeRole::ramp;
}

}  // namespace

relief::LayeredMesh stack_parts(const PlanarMesh& base, const std::vector<Cover>& parts) {
  relief::LayeredMesh mesh;
  mesh.vertices = base.vertices;
  mesh.triangles = base.triangles;
  mesh.part_count = static_cast<int>(parts.size());
  link_neighbours(mesh);
  std::vector<std::vector<bool>> cover;
  std::vector<std::map<int, int>> nodes(parts.size());
  for (int p = 0; p < mesh.part_count; ++p) {
    cover.push_back(covered_triangles(base, parts[p]));
    const std::set<int> rim = rim_of(mesh, cover[p]);
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int k = 0; k < 3 && cover[p][t]; ++k) {
        const int vertex = mesh.triangles[t][k];
        if (!nodes[p].insert({vertex, static_cast<int>(mesh.node_vertex.size())}).second) continue;
        mesh.node_vertex.push_back(vertex);
        mesh.node_part.push_back(p);
        mesh.node_role.push_back(rim.count(vertex) > 0 ? relief::NodeRole::outline
                                                       : relief::NodeRole::interior);
      }
  }
  mesh.stack_begin = {0};
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    for (int p = 0; p < mesh.part_count; ++p) {
      if (!cover[p][t]) continue;
      mesh.face_triangle.push_back(static_cast<int>(t));
      mesh.face_part.push_back(p);
      mesh.faces.push_back({nodes[p].at(a), nodes[p].at(b), nodes[p].at(c)});
    }
    mesh.stack_begin.push_back(static_cast<int>(mesh.faces.size()));
  }
  return mesh;
}

void add_outline_pairs(relief::LayeredMesh& mesh) {
  std::set<std::array<int, 2>> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int upper = mesh.stack_begin[t]; upper < mesh.stack_begin[t + 1]; ++upper)
      for (int lower = mesh.stack_begin[t]; lower < upper; ++lower)
        for (int k = 0; k < 3; ++k) {
          const int a = mesh.faces[lower][k];
          const int b = mesh.faces[upper][k];
          if (a != b && is_outline(mesh, a) != is_outline(mesh, b)) pairs.insert({a, b});
        }
  for (const auto& [lower, upper] : pairs) mesh.constraints.push_back({lower, upper, false});
}

void join_parts(relief::LayeredMesh& mesh, int upper, int lower,
                const std::function<bool(Point2)>& on_join) {
  std::map<int, int> upper_node;
  for (int n = 0; n < static_cast<int>(mesh.node_vertex.size()); ++n)
    if (mesh.node_part[n] == upper && on_join(mesh.vertices[mesh.node_vertex[n]])) {
      upper_node[mesh.node_vertex[n]] = n;
      mesh.node_role[n] = relief::NodeRole::seam;
    }
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.face_part[f] != lower) continue;
    const int t = mesh.face_triangle[f];
    const auto stack = mesh.face_part.begin();
    const bool covered = std::find(stack + mesh.stack_begin[t], stack + mesh.stack_begin[t + 1],
                                   upper) != stack + mesh.stack_begin[t + 1];
    for (int& node : mesh.faces[f]) {
      const auto join = upper_node.find(mesh.node_vertex[node]);
      if (join == upper_node.end()) continue;
      if (covered)
        mesh.node_role[node] = relief::NodeRole::flap;
      else
        node = join->second;
    }
  }
}

int node_at(const relief::LayeredMesh& mesh, int part, int vertex) {
  for (int n = 0; n < static_cast<int>(mesh.node_vertex.size()); ++n)
    if (mesh.node_vertex[n] == vertex && mesh.node_part[n] == part) return n;
  return -1;
}

Point2 middle_of_face(const relief::LayeredMesh& mesh, int face) {
  Point2 sum;
  for (const int n : mesh.faces[face]) sum = sum + 1.0 / 3 * mesh.vertices[mesh.node_vertex[n]];
  return sum;
}

Scene scene_of(const relief::LayeredMesh& mesh, double c, double d) {
  Scene scene;
  scene.width = 1000;
  scene.height = 1000;
  for (int p = 0; p < mesh.part_count; ++p)
    scene.parts.push_back({"part" + std::to_string(p), {}, c, d});
  return scene;
}

Cover in_disc(Point2 centre, double radius) {
  return [=](int, Point2 p) { return distance(p, centre) < radius; };
}

Cover in_box(Point2 min, Point2 max) {
  return [=](int, Point2 p) { return p.x > min.x && p.x < max.x && p.y > min.y && p.y < max.y; };
}

relief::LayeredMesh scattered_discs(int count, double cell) {
  std::vector<Cover> parts = {in_disc({500, 500}, 380)};
  for (int i = 0; i < count; ++i) {
    const double angle = 2.4 * i;
    const double radius = 60 + 11 * (i * 7 % 10);
    const double out = 400 * std::sqrt((i + 0.5) / count);
    parts.push_back(in_disc({500 + out * std::cos(angle), 500 + out * std::sin(angle)}, radius));
  }
  const int cells = static_cast<int>(1100 / cell);
  relief::LayeredMesh mesh = stack_parts(grid_mesh(cells, cells, 1100.0 / cells), parts);
  add_outline_pairs(mesh);
  return mesh;
}

}  // namespace relievo::testing
