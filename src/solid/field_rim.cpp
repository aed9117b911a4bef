#include "solid/field_rim.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "kernel/meshing/triangulate.h"

namespace relievo {
namespace {

using Edge = std::array<int, 2>;

/// Returns the directed edges of the rim between points, the field to their left, sorted.
std::vector<Edge> rim_edges(const HeightField& field, const FieldEdges& edges) {
  std::vector<Edge> rim;
  for (size_t t = 0; t < field.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (edges.across[t][k] < 0)
        rim.push_back({field.vertex_point[field.triangles[t][k]],
                       field.vertex_point[field.triangles[t][(k + 1) % 3]]});
  std::sort(rim.begin(), rim.end());
  return rim;
}

/// A triangulation that has lines as edges, and its regions between them.
struct Regions {
  PlanarTriangulation mesh;   ///< of local numbers
  std::vector<int> region;    ///< #T
  std::vector<char> covered;  ///< by region, whether it lies left of a rim
};

/// Triangulates points in regions between `lines`, which are directed and sorted. `is_rim`: whether
/// a line bounds the field.
Result<Regions> find_regions(const std::vector<Point2>& points, const std::vector<Edge>& lines,
                             const std::vector<char>& is_rim) {
  auto mesh = triangulate(points, lines);
  if (!mesh) return mesh.error();
  Regions regions{std::move(*mesh), {}, {}};
  regions.region.assign(regions.mesh.triangles.size(), -1);
  const auto line_at = [&lines](int a, int b) {
    const auto at = std::lower_bound(lines.begin(), lines.end(), Edge{a, b});
    return at != lines.end() && *at == Edge{a, b} ? static_cast<int>(at - lines.begin()) : -1;
  };
  for (size_t seed = 0; seed < regions.region.size(); ++seed) {
    if (regions.region[seed] >= 0) continue;
    const int number = static_cast<int>(regions.covered.size());
    regions.covered.push_back(0);
    std::vector<int> open{static_cast<int>(seed)};
    regions.region[seed] = number;
    while (!open.empty()) {
      const int t = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int a = regions.mesh.triangles[t][(k + 1) % 3];
        const int b = regions.mesh.triangles[t][(k + 2) % 3];
        const int left = line_at(a, b);
        if (left >= 0 && is_rim[left] != 0) regions.covered[number] = 1;
        const int other = regions.mesh.neighbours[t][k];
        if (left >= 0 || line_at(b, a) >= 0 || other < 0 || regions.region[other] >= 0) continue;
        regions.region[other] = number;
        open.push_back(other);
      }
    }
  }
  return regions;
}

/// The points of a rim, numbered in the order of their numbers in the field.
struct RimPoints {
  std::vector<int> global;  ///< number in the field
  std::vector<Point2> places;
  std::vector<Edge> lines;  ///< between local numbers
};

RimPoints number_rim(const HeightField& field, const std::vector<Edge>& rim) {
  RimPoints points;
  for (const Edge& edge : rim) points.global.push_back(edge[0]);
  points.global.erase(std::unique(points.global.begin(), points.global.end()), points.global.end());
  for (const int p : points.global) points.places.push_back(as_point(field.points[p]));
  const auto local = [&points](int p) {
    return static_cast<int>(std::lower_bound(points.global.begin(), points.global.end(), p) -
                            points.global.begin());
  };
  for (const Edge& edge : rim) points.lines.push_back({local(edge[0]), local(edge[1])});
  return points;
}

}  // namespace

std::vector<std::vector<int>> rim_rings(const HeightField& field, const FieldEdges& edges) {
  const std::vector<Edge> rim = rim_edges(field, edges);
  std::vector<char> used(rim.size());
  std::vector<std::vector<int>> rings;
  for (size_t first = 0; first < rim.size(); ++first) {
    std::vector<int> ring;
    for (size_t e = first; e < rim.size() && used[e] == 0;) {
      used[e] = 1;
      ring.push_back(rim[e][0]);
      const int next = rim[e][1];
      e = static_cast<size_t>(std::lower_bound(rim.begin(), rim.end(), Edge{next, -1}) -
                              rim.begin());
      while (e < rim.size() && rim[e][0] == next && used[e] != 0) ++e;
      if (e < rim.size() && rim[e][0] != next) break;
    }
    if (!ring.empty()) rings.push_back(std::move(ring));
  }
  return rings;
}

Result<std::vector<std::array<int, 3>>> triangulate_inside(const HeightField& field,
                                                           const FieldEdges& edges) {
  const RimPoints rim = number_rim(field, rim_edges(field, edges));
  const auto regions = find_regions(rim.places, rim.lines, std::vector<char>(rim.lines.size(), 1));
  if (!regions) return regions.error();
  std::vector<std::array<int, 3>> triangles;
  for (size_t t = 0; t < regions->region.size(); ++t) {
    if (regions->covered[regions->region[t]] == 0) continue;
    const std::array<int, 3>& local = regions->mesh.triangles[t];
    triangles.push_back({rim.global[local[0]], rim.global[local[1]], rim.global[local[2]]});
  }
  return triangles;
}

Status surround(const Outline& outline, int64_t height, int part, Point2 uv,
                const FieldEdges& edges, HeightField& field) {
  RimPoints rim = number_rim(field, rim_edges(field, edges));
  std::vector<std::pair<Edge, char>> lines;
  for (const Edge& line : rim.lines) lines.push_back({line, 1});
  for (const Ring& ring : outline) {
    const int first = static_cast<int>(rim.places.size());
    const int count = static_cast<int>(ring.size());
    for (int i = 0; i < count; ++i) {
      rim.global.push_back(static_cast<int>(field.points.size()));
      field.points.push_back({std::llround(ring[i].x), std::llround(ring[i].y)});
      rim.places.push_back(as_point(field.points.back()));
      lines.push_back({{first + i, first + (i + 1) % count}, 0});
    }
  }
  std::sort(lines.begin(), lines.end());
  std::vector<Edge> sorted;
  std::vector<char> is_rim;
  for (const auto& [line, bounds] : lines) {
    sorted.push_back(line);
    is_rim.push_back(bounds);
  }
  const auto regions = find_regions(rim.places, sorted, is_rim);
  if (!regions) return regions.error();
  std::vector<int> vertex(rim.global.size(), -1);
  std::vector<signed char> wanted(regions->covered.size(), -1);
  for (size_t t = 0; t < regions->region.size(); ++t) {
    const std::array<int, 3>& local = regions->mesh.triangles[t];
    signed char& want = wanted[regions->region[t]];
    if (want < 0) {
      const Point2 middle =
          (1.0 / 3) * (rim.places[local[0]] + rim.places[local[1]] + rim.places[local[2]]);
      want = regions->covered[regions->region[t]] == 0 && contains(outline, middle) ? 1 : 0;
    }
    if (want == 0) continue;
    std::array<int, 3> triangle{};
    for (int k = 0; k < 3; ++k) {
      int& v = vertex[local[k]];
      if (v < 0) v = field.add_vertex(rim.global[local[k]], height, {0, 0, 1}, uv);
      triangle[k] = v;
    }
    field.triangles.push_back(triangle);
    field.triangle_part.push_back(part);
  }
  return Done{};
}

}  // namespace relievo
