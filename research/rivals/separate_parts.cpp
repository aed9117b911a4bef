#include "research/rivals/separate_parts.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "seams/seam_chains.h"

namespace relievo::research {
namespace {

class Separator {
 public:
  Separator(const relief::LayeredMesh& joined, Roots roots) : joined_(joined), roots_(roots) {
    node_.assign(joined.vertices.size() * static_cast<size_t>(joined.part_count), -1);
  }

  SeparateParts run() {
    relief::LayeredMesh& mesh = out_.mesh;
    mesh.vertices = joined_.vertices;
    mesh.triangles = joined_.triangles;
    mesh.neighbours = joined_.neighbours;
    mesh.part_count = joined_.part_count;
    mesh.edge_length = joined_.edge_length;
    mesh.warnings = joined_.warnings;
    copy_faces();
    find_outlines();
    open_roots();
    copy_pairs();
    for (size_t n = 0; n < joined_.node_vertex.size(); ++n)
      out_.separate_node.push_back(separate_node(static_cast<int>(n)));
    return std::move(out_);
  }

 private:
  int& node_at(int part, int vertex) {
    return node_[static_cast<size_t>(vertex) * joined_.part_count + part];
  }

  void copy_faces() {
    relief::LayeredMesh& mesh = out_.mesh;
    mesh.stack_begin.push_back(0);
    for (size_t t = 0; t < joined_.triangles.size(); ++t) {
      for (int f = joined_.stack_begin[t]; f < joined_.stack_begin[t + 1]; ++f) {
        // The faces of a bump replace those below it.
        if (joined_.source(f) != joined_.face_part[f]) add_face(joined_.source(f), f);
        add_face(joined_.face_part[f], f);
      }
      mesh.stack_begin.push_back(static_cast<int>(mesh.faces.size()));
    }
  }

  /// Returns the face of `part` in place of the joined face.
  void add_face(int part, int face) {
    relief::LayeredMesh& mesh = out_.mesh;
    const int t = joined_.face_triangle[face];
    std::array<int, 3> nodes{};
    for (int k = 0; k < 3; ++k) {
      int& node = node_at(part, joined_.triangles[t][k]);
      const int joined_node = joined_.faces[face][k];
      if (node < 0) {
        node = static_cast<int>(mesh.node_vertex.size());
        mesh.node_vertex.push_back(joined_.triangles[t][k]);
        mesh.node_part.push_back(part);
        mesh.node_role.push_back(relief::NodeRole::interior);
        out_.joined_node.push_back(joined_node);
      }
      int& known = out_.joined_node[node];
      if (joined_.node_part[joined_node] > joined_.node_part[known]) known = joined_node;
      nodes[k] = node;
    }
    mesh.faces.push_back(nodes);
    mesh.face_part.push_back(part);
    mesh.face_triangle.push_back(t);
  }

  bool covers(int part, int triangle) const {
    const relief::LayeredMesh& mesh = out_.mesh;
    if (triangle < 0) return false;
    const auto begin = mesh.face_part.begin();
    const auto end = begin + mesh.stack_begin[triangle + 1];
    return std::find(begin + mesh.stack_begin[triangle], end, part) != end;
  }

  void find_outlines() {
    relief::LayeredMesh& mesh = out_.mesh;
    for (size_t f = 0; f < mesh.faces.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int t = mesh.face_triangle[f];
        if (covers(mesh.face_part[f], mesh.neighbours[t][k])) continue;
        for (const int side : {1, 2})
          mesh.node_role[mesh.faces[f][(k + side) % 3]] = relief::NodeRole::outline;
      }
  }

  /// The nodes of a seam are those of the upper part and the ones that the joined surface had there
  /// of the lower part.
  void open_roots() {
    for (const testing::SeamChain& chain : testing::seam_chains(joined_))
      for (size_t i = 0; i < chain.nodes.size(); ++i) {
        const int vertex = joined_.node_vertex[chain.nodes[i]];
        const int upper = node_at(chain.upper, vertex);
        const int lower = part_below(chain, i);
        if (upper < 0 || lower < 0) continue;
        const bool inside = i > 0 && i + 1 < chain.nodes.size();
        if (roots_ == Roots::open && inside) out_.mesh.node_role[upper] = relief::NodeRole::seam;
        add_pair(node_at(lower, vertex), upper, roots_ == Roots::open);
      }
    add_bump_pairs();
  }

  /// Returns the part behind the upper one whose faces share node i of the chain, or -1.
  int part_below(const testing::SeamChain& chain, size_t i) {
    if (lower_of_.empty())
      for (size_t f = 0; f < joined_.faces.size(); ++f)
        for (const int n : joined_.faces[f]) lower_of_[n].insert(joined_.face_part[f]);
    const std::set<int>& parts = lower_of_[chain.nodes[i]];
    const auto above = parts.lower_bound(chain.upper);
    return above == parts.begin() ? -1 : *std::prev(above);
  }

  /// The rest of the outline of a bump lies on what is below it.
  void add_bump_pairs() {
    for (const relief::BumpNode& bump : joined_.bump_nodes) {
      if (bump.t <= 0) continue;
      const int vertex = joined_.node_vertex[bump.node];
      const int upper = node_at(bump.part, vertex);
      for (int part = bump.part - 1; upper >= 0 && part >= 0; --part) {
        const int lower = node_at(part, vertex);
        if (lower < 0) continue;
        add_pair(lower, upper, false);
        break;
      }
    }
  }

  void copy_pairs() {
    for (const relief::DepthPair& pair : joined_.constraints) {
      const int lower = separate_node(pair.lower);
      const int upper = separate_node(pair.upper);
      if (lower != upper) add_pair(lower, upper, pair.equal);
    }
    std::vector<relief::DepthPair>& pairs = out_.mesh.constraints;
    for (const auto& [nodes, equal] : pairs_) pairs.push_back({nodes.first, nodes.second, equal});
  }

  int separate_node(int node) {
    return node_at(joined_.node_part[node], joined_.node_vertex[node]);
  }

  void add_pair(int lower, int upper, bool equal) {
    bool& known = pairs_[{lower, upper}];
    known = known || equal;
  }

  const relief::LayeredMesh& joined_;
  Roots roots_;
  SeparateParts out_;
  std::vector<int> node_;                      ///< by vertex and part; -1: none
  std::map<int, std::set<int>> lower_of_;      ///< parts at each joined node
  std::map<std::pair<int, int>, bool> pairs_;  ///< (lower, upper): whether they are equal
};

}  // namespace

SeparateParts separate_parts(const relief::LayeredMesh& joined, Roots roots) {
  return Separator(joined, roots).run();
}

}  // namespace relievo::research
