#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::testing {

/// Defects of a triangle array as a surface.
struct Manifoldness {
  int repeated_edges = 0;  ///< directed edges used by more than one triangle
  int bow_ties = 0;        ///< vertices whose triangles form more than one fan
  int boundary_edges = 0;  ///< directed edges without an opposite
  int components = 0;
};

inline Manifoldness check_manifold(const std::vector<std::array<int, 3>>& triangles, int vertices) {
  Manifoldness result;
  std::map<std::pair<int, int>, int> edges;
  for (size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!edges.emplace(std::pair(triangles[t][k], triangles[t][(k + 1) % 3]), t).second)
        ++result.repeated_edges;
  std::vector<int> leaving(vertices, 0);
  for (const auto& [edge, t] : edges)
    if (edges.count({edge.second, edge.first}) == 0) {
      ++result.boundary_edges;
      ++leaving[edge.first];
    }
  for (const int count : leaving) result.bow_ties += count > 1 ? count - 1 : 0;
  std::vector<int> root(vertices);
  for (int v = 0; v < vertices; ++v) root[v] = v;
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  std::vector<bool> used(vertices, false);
  for (const auto& triangle : triangles)
    for (const int v : triangle) {
      used[v] = true;
      root[find(v)] = find(triangle[0]);
    }
  for (int v = 0; v < vertices; ++v) result.components += used[v] && find(v) == v ? 1 : 0;
  return result;
}

inline Manifoldness check_manifold(const relief::LayeredMesh& mesh) {
  return check_manifold(mesh.faces, static_cast<int>(mesh.node_vertex.size()));
}

/// What must hold of every layered mesh; empty if it does, else what does not.
inline std::string inconsistency(const relief::LayeredMesh& mesh, bool in_order = true) {
  const size_t t_count = mesh.triangles.size();
  if (mesh.stack_begin.size() != t_count + 1) return "stack_begin has a wrong length";
  for (size_t t = 0; t < t_count; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]) <= 0)
      return "a base triangle has no positive area";
    if (mesh.stack_begin[t] >= mesh.stack_begin[t + 1]) return "a base triangle is not covered";
    for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f) {
      if (mesh.face_triangle[f] != static_cast<int>(t)) return "face_triangle is wrong";
      for (int g = mesh.stack_begin[t]; g < f; ++g)
        if (mesh.face_part[g] == mesh.face_part[f] ||
            (in_order && mesh.face_part[g] > mesh.face_part[f]))
          return "a stack is not in order";
      for (int k = 0; k < 3; ++k)
        if (mesh.node_vertex[mesh.faces[f][k]] != mesh.triangles[t][k])
          return "a face's node lies at another vertex";
    }
  }
  for (const relief::DepthPair& pair : mesh.constraints)
    if (mesh.node_vertex[pair.lower] != mesh.node_vertex[pair.upper])
      return "a depth pair joins different vertices";
  for (const relief::RampNode& node : mesh.ramp_nodes)
    if (node.t < 0 || node.t >= 1 || node.mass <= 0) return "a ramp node is out of range";
  return "";
}

}  // namespace relievo::testing
