#include "io/overlay/mesh_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace relievo {
namespace {

struct Edge {
  int a = -1;  ///< nodes, a < b
  int b = -1;
  int face = -1;  ///< one of its faces

  bool operator==(const Edge& other) const { return a == other.a && b == other.b; }
  bool operator<(const Edge& other) const { return a != other.a ? a < other.a : b < other.b; }
};

/// Returns every edge once for each of its faces, sorted.
std::vector<Edge> sorted_edges(const relief::LayeredMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.faces.size());
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.faces[f][k];
      const int b = mesh.faces[f][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), f});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

enum class Tie : uint8_t { none, above, below, equal };

Tie tie_of(const relief::LayeredMesh& mesh, const relief::DepthPair& pair) {
  if (pair.equal) return Tie::equal;
  return mesh.node_part[pair.lower] > mesh.node_part[pair.upper] ? Tie::below : Tie::above;
}

std::vector<Tie> ties_of_nodes(const relief::LayeredMesh& mesh) {
  std::vector<Tie> ties(mesh.node_vertex.size(), Tie::none);
  for (const relief::DepthPair& pair : mesh.constraints)
    for (const int node : {pair.lower, pair.upper})
      ties[node] = std::max(ties[node], tie_of(mesh, pair));
  return ties;
}

/// Returns alpha by node: under Robin ranges that of the range, on joins the ramps' start, else 1.
std::vector<float> alphas(const relief::LayeredMesh& mesh, double usual) {
  std::vector<float> alpha(mesh.node_vertex.size(), 1);
  for (size_t i = 0; i < alpha.size(); ++i)
    if (mesh.node_role[i] == relief::NodeRole::seam) alpha[i] = static_cast<float>(usual);
  const auto set = [&](int node, int ramp, double t) {
    const double own = mesh.ramps[ramp].alpha0;
    const double start = own < 0 ? usual : own;
    alpha[node] = static_cast<float>(start + (1 - start) * t);
  };
  for (const relief::RampNode& node : mesh.ramp_nodes) set(node.node, node.ramp, node.t);
  for (const relief::BumpNode& node : mesh.bump_nodes)
    if (node.ramp >= 0) set(node.node, node.ramp, node.t);
  return alpha;
}

/// The part of a bump's outline that a node lies on.
enum class Rim : uint8_t { none, join, ramp, loose };

std::vector<Rim> rims_of_nodes(const relief::LayeredMesh& mesh) {
  std::vector<Rim> rims(mesh.node_vertex.size(), Rim::none);
  for (const relief::BumpNode& node : mesh.bump_nodes)
    rims[node.node] = node.t == 0 ? Rim::join : node.ramp >= 0 ? Rim::ramp : Rim::loose;
  return rims;
}

void add_segment(const relief::LayeredMesh& mesh, Edge edge, std::vector<float>& segments) {
  for (const int node : {edge.a, edge.b}) {
    const Point2 p = mesh.vertices[mesh.node_vertex[node]];
    segments.push_back(static_cast<float>(p.x));
    segments.push_back(static_cast<float>(p.y));
  }
}

class Finder {
 public:
  Finder(const relief::LayeredMesh& mesh, double alpha0)
      : mesh_(mesh),
        ties_(ties_of_nodes(mesh)),
        rims_(rims_of_nodes(mesh)),
        alpha_(alphas(mesh, alpha0)) {}

  void add(Edge edge, bool open, MeshLines& lines) const {
    const relief::NodeRole a = mesh_.node_role[edge.a];
    const relief::NodeRole b = mesh_.node_role[edge.b];
    if (a == relief::NodeRole::seam && b == relief::NodeRole::seam)
      add_segment(mesh_, edge, lines.joins);
    if (rims_[edge.a] != Rim::none && rims_[edge.b] != Rim::none) add_rim(edge, lines);
    if (!open) return;
    if (a == relief::NodeRole::ramp || b == relief::NodeRole::ramp) add_ramp(edge, lines);
    Tie tie = std::min(ties_[edge.a], ties_[edge.b]);
    if (tie == Tie::none && (a == relief::NodeRole::outline || b == relief::NodeRole::outline))
      tie = hidden_tie(edge);
    if (tie == Tie::equal) add_segment(mesh_, edge, lines.equal);
    if (tie == Tie::above) add_segment(mesh_, edge, lines.above);
    if (tie == Tie::below) add_segment(mesh_, edge, lines.below);
  }

 private:
  void add_ramp(Edge edge, MeshLines& lines) const {
    add_segment(mesh_, edge, lines.ramps);
    lines.ramps.push_back(alpha_[edge.a]);
    lines.ramps.push_back(alpha_[edge.b]);
  }

  /// Returns the tie of an outline that lies under another part.
  Tie hidden_tie(Edge edge) const {
    const int front = mesh_.stack_begin[mesh_.face_triangle[edge.face] + 1] - 1;
    if (front == edge.face) return Tie::none;
    return mesh_.face_part[front] > mesh_.face_part[edge.face] ? Tie::above : Tie::below;
  }

  void add_rim(Edge edge, MeshLines& lines) const {
    const Rim rim = std::max(rims_[edge.a], rims_[edge.b]);
    if (rim == Rim::join) return add_segment(mesh_, edge, lines.joins);
    add_segment(mesh_, edge, lines.equal);
    if (rim == Rim::ramp) add_ramp(edge, lines);
  }

  const relief::LayeredMesh& mesh_;
  std::vector<Tie> ties_;
  std::vector<Rim> rims_;
  std::vector<float> alpha_;
};

}  // namespace

MeshLines find_mesh_lines(const relief::LayeredMesh& mesh, double alpha0) {
  const std::vector<Edge> edges = sorted_edges(mesh);
  const Finder finder(mesh, alpha0);
  MeshLines lines;
  for (size_t i = 0; i < edges.size();) {
    size_t end = i + 1;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    finder.add(edges[i], end - i == 1, lines);
    i = end;
  }
  return lines;
}

}  // namespace relievo
