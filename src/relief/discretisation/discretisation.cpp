#include "relief/discretisation/discretisation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <tuple>

#include "kernel/base/disjoint_sets.h"
#include "kernel/base/stopwatch.h"
#include "kernel/base/workers.h"
#include "kernel/geometry/triangles.h"
#include "kernel/operators/dissection.h"
#include "kernel/operators/laplacian.h"

namespace relievo::relief {
namespace {

/// Orders the nodes by nested dissection of the base triangulation, in which a vertex weighs as
/// many nodes as it has. Nodes at one vertex are eliminated together.
std::vector<int> elimination_order(const LayeredMesh& mesh, const RunContext& context) {
  std::vector<int> weights(mesh.vertices.size(), 0);
  for (const int v : mesh.node_vertex) ++weights[v];
  const std::vector<int> order =
      dissection_order({mesh.vertices, mesh.triangles}, weights, context);
  std::vector<int> begin(mesh.vertices.size());
  int next = 0;
  for (const int v : order) {
    begin[v] = next;
    next += weights[v];
  }
  std::vector<int> nodes(mesh.node_vertex.size());
  for (size_t n = 0; n < nodes.size(); ++n)
    nodes[begin[mesh.node_vertex[n]]++] = static_cast<int>(n);
  return nodes;
}

/// Rings of faces around creases that make the patch. Stencils differ from those of the mesh at
/// nodes of creases and their neighbours (one ring) and reach two rings farther; the last ring
/// keeps them away from the boundary of the patch.
constexpr int rings = 4;

/// Flags the nodes on creases, #N.
std::vector<uint8_t> crease_nodes(const LayeredMesh& mesh) {
  std::vector<uint8_t> marked(mesh.node_vertex.size(), 0);
  for (const CreaseEdge& edge : mesh.creases) {
    const Triangle& face = mesh.faces[triangle_of(edge.corner[0])];
    const int k = place_of(edge.corner[0]);
    marked[face[next_place(k)]] = marked[face[last_place(k)]] = 1;
  }
  return marked;
}

/// Lists the faces at marked nodes, ascending, and marks all nodes of these faces.
std::vector<int> grow(const LayeredMesh& mesh, std::vector<uint8_t>& marked) {
  std::vector<int> faces;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    if (std::any_of(face.begin(), face.end(), [&](int n) { return marked[n] != 0; }))
      faces.push_back(static_cast<int>(f));
  }
  for (const int f : faces)
    for (const int n : mesh.faces[f]) marked[n] = 1;
  return faces;
}

/// Unites the corners of `faces` that are one vertex of the patch cut along creases. Corner k of
/// the i-th of these faces is 3 i + k.
DisjointSets patch_corners(const LayeredMesh& mesh, const std::vector<int>& faces) {
  std::vector<int> cut;
  for (const CreaseEdge& edge : mesh.creases)
    cut.insert(cut.end(), edge.corner.begin(), edge.corner.end());
  std::sort(cut.begin(), cut.end());
  std::vector<std::array<int, 4>> edges;  // both nodes, and the corners there, lower node first
  for (int i = 0; i < static_cast<int>(faces.size()); ++i)
    for (int k = 0; k < 3; ++k) {
      if (std::binary_search(cut.begin(), cut.end(), corner_of(faces[i], k))) continue;
      int a = next_place(k);
      int b = last_place(k);
      const auto& face = mesh.faces[faces[i]];
      if (face[a] > face[b]) std::swap(a, b);
      edges.push_back({face[a], face[b], corner_of(i, a), corner_of(i, b)});
    }
  std::sort(edges.begin(), edges.end());
  DisjointSets corners(static_cast<int>(3 * faces.size()));
  for (size_t e = 1; e < edges.size(); ++e) {
    if (std::tie(edges[e][0], edges[e][1]) != std::tie(edges[e - 1][0], edges[e - 1][1])) continue;
    corners.unite(edges[e][2], edges[e - 1][2]);
    corners.unite(edges[e][3], edges[e - 1][3]);
  }
  return corners;
}

}  // namespace

Discretisation discretise(const LayeredMesh& mesh, const RunContext& context) {
  Discretisation result;
  result.scale = scene_scale(mesh);
  const std::vector<Point2> in_px = node_positions(mesh);
  const std::vector<Point2> in_units = node_positions(mesh, result.scale);
  const std::vector<std::array<int, 3>> faces = shaping_faces(mesh);
  const FlatMesh flat{in_units, faces};
  result.surface = joined_surfaces(mesh);
  if (context.cancelled()) return result;
  const Stopwatch all;
  double analysing = 0;
  const std::array<std::function<void()>, 3> work = {
      [&] {
        const Stopwatch own;
        result.elimination = elimination_order(mesh, context);
        analysing = own.milliseconds();
      },
      [&] {
        result.L = stiffness_matrix(flat);
        result.mass = lumped_mass(flat);
      },
      [&] {
        result.gradients = gradient_stencils({in_px, faces});
        result.creases = crease_stencils(mesh);
      },
  };
  run_tasks(3, [&](int i) { work[i](); });
  if (!context.timed) return result;
  context.timed("analyse", analysing);
  context.timed("assemble", all.milliseconds() - analysing);
  return result;
}

CreaseStencils crease_stencils(const LayeredMesh& mesh) {
  CreaseStencils stencils;
  if (mesh.creases.empty()) return stencils;
  std::vector<uint8_t> marked = crease_nodes(mesh);
  std::vector<int> faces = grow(mesh, marked);
  const std::vector<uint8_t> near = marked;
  for (int ring = 1; ring < rings; ++ring) faces = grow(mesh, marked);
  DisjointSets corners = patch_corners(mesh, faces);
  std::vector<int> vertex(3 * faces.size());
  std::vector<Triangle> triangles(faces.size());
  std::vector<Point2> positions;
  for (Corner i = 0; i < static_cast<int>(vertex.size()); ++i) {
    const int node = mesh.faces[faces[triangle_of(i)]][place_of(i)];
    if (corners.find(i) == i) {
      vertex[i] = static_cast<int>(stencils.node.size());
      stencils.node.push_back(node);
      positions.push_back(mesh.vertices[mesh.node_vertex[node]]);
    }
    vertex[i] = vertex[corners.find(i)];
    triangles[triangle_of(i)][place_of(i)] = vertex[i];
    if (near[node] == 0) continue;
    stencils.corner.push_back(corner_of(faces[triangle_of(i)], place_of(i)));
    stencils.vertex.push_back(vertex[i]);
  }
  stencils.gradients = gradient_stencils({positions, triangles});
  return stencils;
}

std::vector<Point2> crease_gradients(const CreaseStencils& stencils,
                                     const std::vector<double>& values) {
  if (stencils.corner.empty()) return {};
  std::vector<double> own;
  own.reserve(stencils.node.size());
  for (const int node : stencils.node) own.push_back(values[node]);
  const std::vector<Point2> gradients = node_gradients(stencils.gradients, own);
  std::vector<Point2> at_corners;
  at_corners.reserve(stencils.vertex.size());
  for (const int vertex : stencils.vertex) at_corners.push_back(gradients[vertex]);
  return at_corners;
}

}  // namespace relievo::relief
