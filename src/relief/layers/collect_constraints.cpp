#include "relief/layers/collect_constraints.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "kernel/base/disjoint_sets.h"
#include "kernel/geometry/polygon.h"

namespace relievo::relief {
namespace {

/// A node at the vertex at hand, and a part whose faces use it there.
struct NodeUse {
  int node;
  int part;
  friend bool operator==(const NodeUse&, const NodeUse&) = default;
};

/// A pair that may be kept, and its importance if not all can be.
struct Candidate {
  int lower;  // indices into the local nodes
  int upper;
  bool equal;
  bool swapped;  // h[upper] <= h[lower]
  bool upper_outline;
};

/// Makes parts equal at the common ends of ranges "above" and "below", where they pass through each
/// other. Precondition: vertices are sorted.
std::vector<PlacedRelation> common_ends(const std::vector<PlacedRelation>& relations) {
  std::vector<PlacedRelation> ties;
  for (const PlacedRelation& a : relations)
    for (const PlacedRelation& b : relations) {
      if (a.kind != RelationKind::above || b.kind != RelationKind::below || !a.limited) continue;
      if (a.upper != b.upper || a.lower != b.lower) continue;
      PlacedRelation tie{-1, a.upper, a.lower, RelationKind::equal, true, {}};
      std::set_intersection(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                            b.vertices.end(), std::back_inserter(tie.vertices));
      ties.push_back(std::move(tie));
    }
  return ties;
}

/// Sorts relations by precedence, those with a range first, and their vertices by number.
std::vector<PlacedRelation> by_precedence(std::vector<PlacedRelation> relations) {
  for (PlacedRelation& relation : relations)
    std::sort(relation.vertices.begin(), relation.vertices.end());
  const std::vector<PlacedRelation> ties = common_ends(relations);
  relations.insert(relations.begin(), ties.begin(), ties.end());
  std::stable_partition(relations.begin(), relations.end(),
                        [](const PlacedRelation& relation) { return relation.limited; });
  return relations;
}

class Collector {
 public:
  Collector(const SheetMesh& mesh, const Boundaries& boundaries,
            const std::vector<PlacedRelation>& relations, const LocalOrder& order)
      : mesh_(mesh),
        boundaries_(boundaries),
        relations_(by_precedence(relations)),
        order_(order),
        glued_below_(mesh.node_vertex.size(), -1),
        enclosed_(mesh.node_vertex.size(), false) {
    for (const DepthPair& pair : boundaries.glued) glued_below_[pair.upper] = pair.lower;
    find_enclosed();
  }

  std::vector<DepthPair> run() {
    std::vector<int> nodes_at(mesh_.points.size(), 0);
    for (const int vertex : mesh_.node_vertex) ++nodes_at[vertex];
    for (size_t v = 0; v < mesh_.points.size(); ++v) {
      if (nodes_at[v] < 2) continue;
      gather(static_cast<int>(v));
      if (local_.size() < 2) continue;
      propose(static_cast<int>(v));
      keep_forest();
    }
    return std::move(pairs_);
  }

 private:
  NodeRole role(int node) const { return boundaries_.role[node]; }
  bool on_outline(int node) const {
    return role(node) == NodeRole::outline || role(node) == NodeRole::ramp;
  }

  void gather(int vertex) {
    local_.clear();
    uses_.clear();
    for (const Corner corner : mesh_.base_corners.at(vertex)) {
      const int t = triangle_of(corner);
      for (int f = mesh_.stack_begin[t]; f < mesh_.stack_begin[t + 1]; ++f)
        note(mesh_.faces[f][place_of(corner)], mesh_.face_part[f]);
    }
    std::sort(local_.begin(), local_.end(), [](const NodeUse& a, const NodeUse& b) {
      return a.part != b.part ? a.part < b.part : a.node < b.node;
    });
  }

  void note(int node, int part) {
    auto at = std::find_if(local_.begin(), local_.end(),
                           [node](const NodeUse& use) { return use.node == node; });
    if (at == local_.end()) at = local_.insert(local_.end(), NodeUse{node, part});
    at->part = std::max(at->part, part);
    if (!uses(node, part)) uses_.push_back({node, part});
  }

  bool uses(int node, int part) const {
    return std::find(uses_.begin(), uses_.end(), NodeUse{node, part}) != uses_.end();
  }

  // Marks the nodes of enclosed loops. A loop of an unjoined part is enclosed if every vertex lies
  // inside some lower part; a hole only if all loops of its part are.
  void find_enclosed() {
    std::vector<bool> joined(mesh_.surface.size(), false);
    for (const Seam& seam : mesh_.seams) joined[seam.upper] = true;
    std::vector<bool> whole(mesh_.surface.size(), true);
    std::vector<bool> inside(mesh_.loops.size());
    for (size_t l = 0; l < mesh_.loops.size(); ++l) {
      const std::vector<int>& loop = mesh_.loops[l];
      inside[l] = std::all_of(loop.begin(), loop.end(), [&](int vertex) {
        return inside_lower_part(vertex, mesh_.loop_part[l]);
      });
      if (!inside[l]) whole[mesh_.loop_part[l]] = false;
    }
    for (size_t l = 0; l < mesh_.loops.size(); ++l) {
      const int part = mesh_.loop_part[l];
      if (!inside[l] || joined[part] || (is_hole(mesh_.loops[l]) && !whole[part])) continue;
      mark_enclosed(mesh_.loops[l], part);
    }
  }

  bool is_hole(const std::vector<int>& loop) const {
    Ring ring;
    for (const int vertex : loop) ring.push_back(mesh_.points[vertex]);
    return signed_area(ring) < 0;
  }

  bool inside_lower_part(int vertex, int part) {
    gather(vertex);
    return std::any_of(local_.begin(), local_.end(), [&](const NodeUse& use) {
      return use.part < part && !on_outline(use.node);
    });
  }

  void mark_enclosed(const std::vector<int>& loop, int part) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      for (const int vertex : {a, b}) {
        const int node = mesh_.outline_node(part, a, b, vertex);
        if (node >= 0) enclosed_[node] = true;
      }
    }
  }

  const PlacedRelation* relation_at(int vertex, const NodeUse& lower, const NodeUse& upper) const {
    for (const PlacedRelation& relation : relations_)
      if (uses(upper.node, relation.upper) && uses(lower.node, relation.lower) &&
          (!relation.limited ||
           std::binary_search(relation.vertices.begin(), relation.vertices.end(), vertex)))
        return &relation;
    return nullptr;
  }

  void propose(int vertex) {
    candidates_.clear();
    for (size_t b = 1; b < local_.size(); ++b) {
      bool nearest = true;  // no inner node below this one was met yet
      for (size_t a = b; a-- > 0;) {
        const bool inner = !on_outline(local_[a].node);
        propose_pair(static_cast<int>(a), static_cast<int>(b), vertex, nearest);
        nearest = nearest && !inner;
      }
    }
  }

  void propose_pair(int a, int b, int vertex, bool nearest) {
    const NodeUse& lower = local_[a];
    const NodeUse& upper = local_[b];
    const bool lower_outline = on_outline(lower.node);
    const bool upper_outline = on_outline(upper.node);
    const bool flap = role(lower.node) == NodeRole::flap || role(upper.node) == NodeRole::flap;
    if (lower_outline == upper_outline && (lower_outline || !flap)) return;
    const PlacedRelation* relation = relation_at(vertex, lower, upper);
    if (relation != nullptr && relation->kind == RelationKind::free) return;
    const Sense sense = sense_of(relation, vertex, lower, upper);
    if (sense == Sense::mixed) return;
    const bool glued = glued_below_[upper.node] == lower.node;
    const bool tied = relation != nullptr ? is_tie(relation->kind) : glued || enclosed_[upper.node];
    const bool swapped = sense == Sense::swapped;
    candidates_.push_back(
        {a, b, tied && !swapped && upper_outline && nearest, swapped, upper_outline});
  }

  // The sense that a relation with a range demands, or else that of the faces around the vertex.
  Sense sense_of(const PlacedRelation* relation, int vertex, const NodeUse& lower,
                 const NodeUse& upper) const {
    if (relation != nullptr && relation->limited)
      return relation->kind == RelationKind::below ? Sense::swapped : Sense::usual;
    return sense_at(mesh_, order_, vertex, lower.part, upper.part);
  }

  // Keeps the most important candidates that close no cycle: equalities, then pairs against the
  // order of parts, then pairs with the fewest nodes between them.
  void keep_forest() {
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
      if (x.equal != y.equal) return x.equal;
      if (x.swapped != y.swapped) return x.swapped;
      if (x.upper - x.lower != y.upper - y.lower) return x.upper - x.lower < y.upper - y.lower;
      if (x.upper_outline != y.upper_outline) return x.upper_outline;
      return x.upper != y.upper ? x.upper > y.upper : x.lower > y.lower;
    });
    DisjointSets trees(static_cast<int>(local_.size()));
    for (const Candidate& candidate : candidates_) {
      if (trees.find(candidate.lower) == trees.find(candidate.upper)) continue;
      trees.unite(candidate.lower, candidate.upper);
      DepthPair pair{local_[candidate.lower].node, local_[candidate.upper].node, candidate.equal};
      if (candidate.swapped) std::swap(pair.lower, pair.upper);
      pairs_.push_back(pair);
    }
  }

  const SheetMesh& mesh_;
  const Boundaries& boundaries_;
  std::vector<PlacedRelation> relations_;
  const LocalOrder& order_;
  std::vector<int> glued_below_;  // per node, or -1
  std::vector<bool> enclosed_;    // per node
  std::vector<NodeUse> local_;    // each node at the vertex with its frontmost part, back to front
  std::vector<NodeUse> uses_;     // each node at the vertex with each of its parts
  std::vector<Candidate> candidates_;
  std::vector<DepthPair> pairs_;
};

/// Returns the face on which the front one over triangle t may rest, or -1. `free`: free_parts.
int support(const LayeredMesh& mesh, const std::vector<std::pair<int, int>>& free, size_t t) {
  const int front = mesh.stack_begin[t + 1] - 1;
  for (int f = front - 1; f >= mesh.stack_begin[t]; --f)
    if (mesh.flap(f) == Flap::none && !may_cross(mesh, free, front, f)) return f;
  return -1;
}

}  // namespace

std::vector<DepthPair> collect_constraints(const SheetMesh& mesh, const Boundaries& boundaries,
                                           const std::vector<PlacedRelation>& relations,
                                           const LocalOrder& order) {
  return Collector(mesh, boundaries, relations, order).run();
}

std::vector<DepthPair> resting_pairs(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<std::pair<int, int>> free = free_parts(scene);
  std::vector<DepthPair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int front = mesh.stack_begin[t + 1] - 1;
    if (front <= mesh.stack_begin[t] || scene.parts[mesh.face_part[front]].d < 0) continue;
    const int below = support(mesh, free, t);
    if (below < 0) continue;
    for (int k = 0; k < 3; ++k) {
      const DepthPair pair{mesh.faces[below][k], mesh.faces[front][k], false};
      if (pair.lower != pair.upper && is_inside(mesh.node_role[pair.lower]) &&
          is_inside(mesh.node_role[pair.upper]))
        pairs.push_back(pair);
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const DepthPair& a, const DepthPair& b) {
    return std::tie(a.lower, a.upper) < std::tie(b.lower, b.upper);
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace relievo::relief
