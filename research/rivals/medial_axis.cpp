#include "research/rivals/medial_axis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "kernel/meshing/triangulate.h"

namespace relievo::research {
namespace {

constexpr double least_detour = 1.6;
/// Spacing of centres along a branch / the radius there.
constexpr double centre_spacing = 0.5;

struct Samples {
  std::vector<Point2> points;
  std::vector<int> ring;       ///< of each point
  std::vector<double> s;       ///< arc length along it
  std::vector<double> length;  ///< of each ring
};

Samples sample(const Outline& outline, double spacing) {
  Samples samples;
  std::set<std::pair<double, double>> known;
  for (const Ring& ring : outline) {
    const RingMeasure along = measure(ring);
    const int count = std::max(3, static_cast<int>(std::ceil(along.length / spacing)));
    for (int i = 0; i < count; ++i) {
      const double s = along.length * i / count;
      const Point2 p = point_at(ring, along, s);
      if (!known.insert({p.x, p.y}).second) continue;
      samples.points.push_back(p);
      samples.ring.push_back(static_cast<int>(samples.length.size()));
      samples.s.push_back(s);
    }
    samples.length.push_back(along.length);
  }
  return samples;
}

struct TouchingDisc {
  Point2 centre;
  double radius = 0;
};

TouchingDisc circumscribed(Point2 a, Point2 b, Point2 c) {
  const Point2 ab = b - a;
  const Point2 ac = c - a;
  const double area = 2 * cross(ab, ac);
  const Point2 away = (1 / area) * Point2{ac.y * dot(ab, ab) - ab.y * dot(ac, ac),
                                          ab.x * dot(ac, ac) - ac.x * dot(ab, ab)};
  return {a + away, norm(away)};
}

/// Checks whether two samples are much farther apart along the outline than straight.
bool faces_across(const Samples& samples, int a, int b) {
  if (samples.ring[a] != samples.ring[b]) return true;
  const double between = std::abs(samples.s[a] - samples.s[b]);
  const double arc = std::min(between, samples.length[samples.ring[a]] - between);
  return arc > least_detour * distance(samples.points[a], samples.points[b]);
}

/// The discs of a triangulation and their links.
struct Graph {
  std::vector<TouchingDisc> discs;
  std::map<int, std::set<int>> links;
};

Graph voronoi_graph(const Samples& samples, const PlanarTriangulation& mesh,
                    const Outline& outline) {
  Graph graph;
  std::vector<bool> inside;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 p = samples.points[a];
    const Point2 q = samples.points[b];
    const Point2 r = samples.points[c];
    graph.discs.push_back(circumscribed(p, q, r));
    inside.push_back(contains(outline, (1.0 / 3) * (p + q + r)) &&
                     contains(outline, graph.discs.back().centre));
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int other = mesh.neighbours[t][k];
      if (other < t || !inside[t] || !inside[other]) continue;
      const auto& corners = mesh.triangles[t];
      if (!faces_across(samples, corners[(k + 1) % 3], corners[(k + 2) % 3])) continue;
      graph.links[t].insert(other);
      graph.links[other].insert(t);
    }
  if (!graph.links.empty()) return graph;
  int largest = -1;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (inside[t] && (largest < 0 || graph.discs[t].radius > graph.discs[largest].radius))
      largest = t;
  if (largest >= 0) graph.links[largest] = {};
  return graph;
}

/// Keeps ends and forks, and thins the discs between them according to their radius.
class Thinner {
 public:
  explicit Thinner(Graph graph) : graph_(std::move(graph)) {}

  MedialAxis run() {
    std::vector<int> starts;
    for (const auto& [t, next] : graph_.links)
      if (next.size() != 2) starts.push_back(t);
    for (const int t : starts) {
      number(t);
      while (!graph_.links[t].empty()) follow(t);
    }
    // The rest are rings.
    for (auto& [t, next] : graph_.links)
      while (!next.empty()) follow(t);
    return std::move(axis_);
  }

 private:
  int number(int t) {
    const auto [at, is_new] = number_.insert({t, static_cast<int>(axis_.centre.size())});
    if (is_new) {
      axis_.centre.push_back(graph_.discs[t].centre);
      axis_.radius.push_back(graph_.discs[t].radius);
    }
    return at->second;
  }

  void follow(int t) {
    int last = number(t);
    double way = 0;
    while (!graph_.links[t].empty()) {
      const int next = *graph_.links[t].begin();
      way += distance(graph_.discs[t].centre, graph_.discs[next].centre);
      graph_.links[t].erase(next);
      graph_.links[next].erase(t);
      t = next;
      const bool ends = graph_.links[t].size() != 1 || number_.count(t) > 0;
      if (!ends && way < centre_spacing * graph_.discs[t].radius) continue;
      const int here = number(t);
      if (here != last) axis_.edges.push_back({last, here});
      last = here;
      way = 0;
      if (ends) return;
    }
  }

  Graph graph_;
  MedialAxis axis_;
  std::map<int, int> number_;
};

}  // namespace

Result<MedialAxis> medial_axis(const Outline& outline, double spacing) {
  const Samples samples = sample(outline, spacing);
  if (samples.points.size() < 3) return MedialAxis{};
  const auto mesh = triangulate(samples.points, {});
  if (!mesh) return mesh.error();
  return Thinner(voronoi_graph(samples, *mesh, outline)).run();
}

}  // namespace relievo::research
