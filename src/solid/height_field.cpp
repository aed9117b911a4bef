#include "solid/height_field.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace relievo {
namespace {

struct HalfEdge {
  int low = 0;  ///< the smaller of both points
  int high = 0;
  bool forward = false;  ///< whether it runs from low to high
  int triangle = 0;
  int corner = 0;
};

std::vector<HalfEdge> sorted_half_edges(const HeightField& field) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * field.triangles.size());
  for (size_t t = 0; t < field.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = field.vertex_point[field.triangles[t][k]];
      const int b = field.vertex_point[field.triangles[t][(k + 1) % 3]];
      edges.push_back({std::min(a, b), std::max(a, b), a < b, static_cast<int>(t), k});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.forward, a.triangle, a.corner) <
           std::tie(b.low, b.high, b.forward, b.triangle, b.corner);
  });
  return edges;
}

/// Returns the corner of the next triangle counter-clockwise around the same point, or -1 at the
/// rim.
int next_corner(const HeightField& field, const FieldEdges& edges, int corner) {
  const int other = edges.across[corner / 3][(corner % 3 + 2) % 3];
  if (other < 0) return -1;
  const int point = field.vertex_point[field.corner_vertex(corner)];
  for (int k = 0; k < 2; ++k)
    if (field.vertex_point[field.triangles[other][k]] == point) return 3 * other + k;
  return 3 * other + 2;
}

}  // namespace

int64_t HeightField::height_between(int a, int b, double s) const {
  return std::llround((1 - s) * static_cast<double>(vertex_height[a]) +
                      s * static_cast<double>(vertex_height[b]));
}

int HeightField::add_vertex(int point, int64_t height, Point3 normal, Point2 uv) {
  vertex_point.push_back(point);
  vertex_height.push_back(height);
  normals.push_back(normal);
  uvs.push_back(uv);
  return static_cast<int>(vertex_point.size()) - 1;
}

int HeightField::add_vertex_between(int a, int b, double s, int point, int64_t height) {
  return add_vertex(point, height, normalized((1 - s) * normals[a] + s * normals[b]),
                    (1 - s) * uvs[a] + s * uvs[b]);
}

FieldEdges connect_field(const HeightField& field) {
  FieldEdges result;
  result.across.assign(field.triangles.size(), {-1, -1, -1});
  const std::vector<HalfEdge> edges = sorted_half_edges(field);
  for (size_t begin = 0; begin < edges.size();) {
    size_t end = begin + 1;
    while (end < edges.size() && edges[end].low == edges[begin].low &&
           edges[end].high == edges[begin].high)
      ++end;
    const HalfEdge& a = edges[begin];
    const HalfEdge& b = edges[end - 1];
    if (end - begin == 2 && a.forward != b.forward) {
      result.across[a.triangle][a.corner] = b.triangle;
      result.across[b.triangle][b.corner] = a.triangle;
    } else if (end - begin > 1) {
      ++result.crowded;
    }
    begin = end;
  }
  return result;
}

CornerFans collect_fans(const HeightField& field, const FieldEdges& edges) {
  const int corners = static_cast<int>(3 * field.triangles.size());
  std::vector<char> seen(static_cast<size_t>(corners));
  CornerFans fans;
  fans.begin.push_back(0);
  fans.corners.reserve(seen.size());
  const auto walk = [&](int first) {
    int corner = first;
    for (; corner >= 0 && seen[corner] == 0; corner = next_corner(field, edges, corner)) {
      seen[corner] = 1;
      fans.corners.push_back(corner);
    }
    fans.closed.push_back(corner == first);
    fans.begin.push_back(static_cast<int>(fans.corners.size()));
  };
  for (int c = 0; c < corners; ++c)
    if (edges.across[c / 3][c % 3] < 0) walk(c);
  for (int c = 0; c < corners; ++c)
    if (seen[c] == 0) walk(c);
  return fans;
}

}  // namespace relievo
