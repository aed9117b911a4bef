#include "seams/seam_chains.h"

#include <algorithm>
#include <array>
#include <map>

namespace relievo::testing {
namespace {

using Edges = std::map<int, std::vector<int>>;

/// Removes the chain that begins at `node` from the edges, and returns it.
SeamChain take_chain(const relief::LayeredMesh& mesh, int upper, int node, Edges& edges) {
  SeamChain chain{upper, {node}, {0}};
  for (auto at = edges.find(node); at != edges.end() && !at->second.empty();
       at = edges.find(node)) {
    const int next = at->second.back();
    at->second.pop_back();
    std::vector<int>& back = edges[next];
    back.erase(std::find(back.begin(), back.end(), node));
    const double step =
        distance(mesh.vertices[mesh.node_vertex[node]], mesh.vertices[mesh.node_vertex[next]]);
    chain.nodes.push_back(next);
    chain.length.push_back(chain.length.back() + step);
    node = next;
  }
  return chain;
}

}  // namespace

std::set<int> loose_rims(const relief::LayeredMesh& mesh) {
  std::set<int> rims;
  for (const relief::BumpNode& node : mesh.bump_nodes)
    if (node.t > 0) rims.insert(node.node);
  return rims;
}

std::vector<SeamChain> seam_chains(const relief::LayeredMesh& mesh) {
  std::map<int, Edges> edges_of;  // per upper part
  const std::set<int> rims = loose_rims(mesh);
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const int other = relief::face_across(mesh, f, k);
      if (other < 0 || mesh.face_part[other] >= mesh.face_part[f]) continue;
      const int a = mesh.faces[f][(k + 1) % 3];
      const int b = mesh.faces[f][(k + 2) % 3];
      if (rims.count(a) + rims.count(b) > 0) continue;
      edges_of[mesh.face_part[f]][a].push_back(b);
      edges_of[mesh.face_part[f]][b].push_back(a);
    }
  std::vector<SeamChain> chains;
  for (auto& [upper, edges] : edges_of) {
    std::vector<int> starts;
    for (const auto& [node, next] : edges)
      if (next.size() == 1) starts.push_back(node);
    for (const int start : starts)
      if (!edges[start].empty()) chains.push_back(take_chain(mesh, upper, start, edges));
  }
  return chains;
}

}  // namespace relievo::testing
