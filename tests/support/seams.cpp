#include "support/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <type_traits>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::testing {
namespace {

/// The normal times the area of each face, by node and side.
Point3 area_vector(const relief::LayeredMesh& mesh, const std::vector<double>& h, int face) {
  std::array<Point3, 3> p;
  for (int k = 0; k < 3; ++k) {
    const int n = mesh.faces[face][k];
    const Point2 q = mesh.vertices[mesh.node_vertex[n]];
    p[k] = {q.x, q.y, h[n]};
  }
  return cross(p[1] - p[0], p[2] - p[0]);
}

double degrees_between(Point3 a, Point3 b) {
  return std::atan2(std::sqrt(dot(cross(a, b), cross(a, b))), dot(a, b)) * 180 / M_PI;
}

/// Where outlines are seen.
std::vector<Point2> creases(const relief::LayeredMesh& mesh) {
  const std::vector<uint8_t> seen = relief::seen_nodes(mesh);
  const std::set<int> rims = loose_rims(mesh);
  std::vector<Point2> points;
  for (size_t n = 0; n < seen.size(); ++n) {
    const bool drawn = mesh.node_role[n] == relief::NodeRole::outline ||
                       mesh.node_role[n] == relief::NodeRole::ramp ||
                       rims.count(static_cast<int>(n)) > 0;
    if (seen[n] != 0 && drawn) points.push_back(mesh.vertices[mesh.node_vertex[n]]);
  }
  return points;
}

/// How high water stands at most within half the radius around the middle, on what is seen from the
/// front, if it runs off at the circle and at silhouettes.
double deepest_water(const relief::LayeredMesh& mesh, const std::vector<double>& h, Point2 middle,
                     double radius) {
  std::map<int, std::vector<int>> edges;
  std::map<int, std::vector<int>> at_vertex;
  std::map<int, bool> drains;
  const auto away = [&](int n) { return distance(mesh.vertices[mesh.node_vertex[n]], middle); };
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int top = mesh.stack_begin[t + 1] - 1;
    if (top < mesh.stack_begin[t]) continue;
    for (int k = 0; k < 3; ++k) {
      const int n = mesh.faces[top][k];
      if (away(n) > radius) continue;
      for (const int other : mesh.faces[top]) {
        if (other == n) continue;
        edges[n].push_back(other);
        drains[n] = drains[n] || away(other) > radius;
      }
      for (const int side : {1, 2}) drains[n] = drains[n] || mesh.neighbours[t][(k + side) % 3] < 0;
      at_vertex[mesh.node_vertex[n]].push_back(n);
    }
  }
  for (const auto& [vertex, nodes] : at_vertex)
    for (const int a : nodes)
      for (const int b : nodes)
        if (a != b) edges[a].push_back(b);
  using Level = std::pair<double, int>;
  std::priority_queue<Level, std::vector<Level>, std::greater<>> queue;
  for (const auto& [n, out] : drains)
    if (out) queue.push({h[n], n});
  std::map<int, double> level;
  double deepest = 0;
  while (!queue.empty()) {
    const auto [water, n] = queue.top();
    queue.pop();
    if (!level.insert({n, water}).second) continue;
    if (away(n) <= 0.5 * radius) deepest = std::max(deepest, water - h[n]);
    for (const int other : edges[n])
      if (away(other) <= radius && level.count(other) == 0)
        queue.push({std::max(water, h[other]), other});
  }
  return deepest;
}

Point2 position(const relief::LayeredMesh& mesh, int node) {
  return mesh.vertices[mesh.node_vertex[node]];
}

std::vector<double> pits(const relief::LayeredMesh& mesh, const std::vector<double>& h,
                         const SeamChain& chain) {
  const double total = chain.length.back();
  const std::vector<uint8_t> seen = relief::seen_nodes(mesh);
  std::vector<double> result;
  for (const int end : {chain.nodes.front(), chain.nodes.back()}) {
    const Point2 at = mesh.vertices[mesh.node_vertex[end]];
    result.push_back(seen[end] != 0 ? deepest_water(mesh, h, at, 0.5 * total) / total : 0);
  }
  return result;
}

}  // namespace

std::vector<double> seam_angles(const relief::LayeredMesh& mesh, const std::vector<double>& h,
                                const SeamChain& chain) {
  const double total = chain.length.back();
  std::map<int, std::pair<Point3, Point3>> sides;
  for (size_t i = 0; i < chain.nodes.size(); ++i)
    if (chain.length[i] >= 0.25 * total && chain.length[i] <= 0.75 * total)
      sides[chain.nodes[i]] = {};
  std::map<int, int> hidden;
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
    for (const int n : mesh.faces[f]) {
      const auto at = sides.find(n);
      if (at == sides.end()) continue;
      const bool above = mesh.face_part[f] >= chain.upper;
      Point3& sum = above ? at->second.first : at->second.second;
      sum = sum + area_vector(mesh, h, f);
      if (f + 1 < mesh.stack_begin[mesh.face_triangle[f] + 1]) ++hidden[n];
    }
  const std::vector<Point2> drawn = creases(mesh);
  const auto is_smooth = [&](int node) {
    const Point2 at = mesh.vertices[mesh.node_vertex[node]];
    return std::none_of(drawn.begin(), drawn.end(),
                        [&](Point2 p) { return distance(p, at) < 3 * mesh.edge_length; });
  };
  std::vector<double> angles;
  for (const auto& [node, pair] : sides)
    if (hidden[node] == 0 && is_smooth(node))
      angles.push_back(degrees_between(pair.first, pair.second));
  std::sort(angles.begin(), angles.end());
  return angles;
}

JoinEnds join_ends(const relief::LayeredMesh& mesh, const std::vector<double>& h,
                   const SeamChain& chain) {
  std::vector<double> depths = h;
  for (double& depth : depths) depth = -depth;
  return {pits(mesh, h, chain), pits(mesh, depths, chain)};
}

Scene join_alone(const Scene& scene, const relief::LayeredMesh& mesh, const SeamChain& chain) {
  const Point2 middle = position(mesh, chain.nodes[chain.nodes.size() / 2]);
  const Join* join = nullptr;
  for (const Join& other : scene.joins)
    if (other.upper == chain.upper &&
        (join == nullptr ||
         distance_to_polyline(other.line, middle) < distance_to_polyline(join->line, middle)))
      join = &other;
  Scene alone = scene;
  alone.parts = {scene.parts[join->lower], scene.parts[join->upper]};
  const auto keep = [&](auto& all) {
    using Item = typename std::decay_t<decltype(all)>::value_type;
    const auto is_of_others = [&](const Item& item) {
      return item.upper != join->upper || item.lower != join->lower;
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_of_others), all.end());
    for (Item& item : all) item.upper = 1, item.lower = 0;
  };
  const Join own = *join;
  alone.joins = {{1, 0, own.line}};
  keep(alone.relations);
  keep(alone.robin);
  alone.cues.clear();
  for (Cue cue : scene.cues) {
    if (cue.part != own.lower && cue.part != own.upper) continue;
    cue.part = cue.part == own.upper ? 1 : 0;
    alone.cues.push_back(cue);
  }
  return alone;
}

JoinEnds join_ends_alone(const Scene& scene, const relief::LayeredMesh& mesh,
                         const SeamChain& chain, relief::ReliefOptions options) {
  options.layers.edge_length = mesh.edge_length;
  const Result<relief::Relief> relief =
      relief::build_relief(join_alone(scene, mesh, chain), options);
  if (!relief) return {};
  const std::vector<SeamChain> chains = seam_chains(relief->layers);
  if (chains.empty()) return {};
  SeamChain own = chains[0];
  const Point2 first = position(mesh, chain.nodes.front());
  if (distance(position(relief->layers, own.nodes.front()), first) >
      distance(position(relief->layers, own.nodes.back()), first)) {
    std::reverse(own.nodes.begin(), own.nodes.end());
    const double total = own.length.back();
    std::reverse(own.length.begin(), own.length.end());
    for (double& length : own.length) length = total - length;
  }
  return join_ends(relief->layers, relief->ordering.h, own);
}

}  // namespace relievo::testing
