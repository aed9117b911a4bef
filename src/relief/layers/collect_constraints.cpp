#include "relief/layers/collect_constraints.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "kernel/base/disjoint_sets.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

/// A node at the vertex at hand.
struct LocalNode {
  int node;
  int rank;  // frontmost part whose faces use it there
};

/// A part whose faces use a node at the vertex at hand.
struct NodeUse {
  int node;
  int part;
  friend bool operator==(const NodeUse&, const NodeUse&) = default;
};

/// A pair that may be kept, and how much it matters where not all can be.
struct Candidate {
  int lower;  // index into the local nodes
  int upper;
  bool equal;
  bool swapped;  // h[upper] <= h[lower]
  bool upper_outline;
};

/// What a relation of the scene says.
struct Rule {
  int upper;
  int lower;
  RelationKind kind;
  bool limited;
  std::vector<int> vertices;  // sorted; where it holds, if limited
};

/// Where "above" and "below" have a vertex in common, which they only have at their ends, both
/// hold: the parts pass through each other there.
std::vector<Rule> common_ends(const std::vector<Rule>& rules) {
  std::vector<Rule> ties;
  for (const Rule& a : rules)
    for (const Rule& b : rules) {
      if (a.kind != RelationKind::above || b.kind != RelationKind::below || !a.limited) continue;
      if (a.upper != b.upper || a.lower != b.lower) continue;
      Rule tie{a.upper, a.lower, RelationKind::equal, true, {}};
      std::set_intersection(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                            b.vertices.end(), std::back_inserter(tie.vertices));
      ties.push_back(std::move(tie));
    }
  return ties;
}

/// What is said of a range goes before what is said of everywhere.
std::vector<Rule> rules_of(const Scene& scene, const std::vector<LoopRun>& runs,
                           const Loops& loops) {
  std::vector<Rule> rules;
  for (size_t r = 0; r < scene.relations.size(); ++r) {
    const Relation& relation = scene.relations[r];
    Rule rule{relation.upper, relation.lower, relation.kind, relation.range.has_value(), {}};
    if (rule.limited && runs[r].loop >= 0) {
      rule.vertices = run_vertices(loops, runs[r]);
      std::sort(rule.vertices.begin(), rule.vertices.end());
    }
    rules.push_back(std::move(rule));
  }
  const std::vector<Rule> ties = common_ends(rules);
  rules.insert(rules.begin(), ties.begin(), ties.end());
  std::stable_partition(rules.begin(), rules.end(), [](const Rule& rule) { return rule.limited; });
  return rules;
}

class Collector {
 public:
  Collector(const SheetMesh& mesh, const Boundaries& boundaries, const LocalOrder& order,
            std::vector<Rule> rules)
      : mesh_(mesh), boundaries_(boundaries), order_(order), rules_(std::move(rules)) {
    find_enclosed();
    glued_below_.assign(mesh.node_vertex.size(), -1);
    for (const GluedPair& pair : boundaries.glued) glued_below_[pair.upper] = pair.lower;
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
    std::sort(local_.begin(), local_.end(), [](const LocalNode& a, const LocalNode& b) {
      return a.rank != b.rank ? a.rank < b.rank : a.node < b.node;
    });
  }

  void note(int node, int part) {
    auto at = std::find_if(local_.begin(), local_.end(),
                           [&](const LocalNode& entry) { return entry.node == node; });
    if (at == local_.end()) at = local_.insert(local_.end(), LocalNode{node, part});
    at->rank = std::max(at->rank, part);
    if (!uses(node, part)) uses_.push_back({node, part});
  }

  bool uses(int node, int part) const {
    return std::find(uses_.begin(), uses_.end(), NodeUse{node, part}) != uses_.end();
  }

  // A loop of an unjoined part is enclosed where every vertex lies inside some lower part; a
  // hole only where all loops of its part are.
  void find_enclosed() {
    const Loops& loops = mesh_.loops;
    std::vector<bool> joined(mesh_.surface.size(), false);
    for (const Seam& seam : mesh_.seams) joined[seam.upper] = true;
    std::vector<bool> whole(mesh_.surface.size(), true);
    std::vector<bool> inside(loops.vertices.size(), true);
    for (size_t l = 0; l < loops.vertices.size(); ++l) {
      for (const int vertex : loops.vertices[l])
        if (!inside_lower_part(vertex, loops.part[l])) {
          inside[l] = false;
          break;
        }
      if (!inside[l]) whole[loops.part[l]] = false;
    }
    enclosed_.assign(mesh_.node_vertex.size(), false);
    for (size_t l = 0; l < loops.vertices.size(); ++l) {
      const int part = loops.part[l];
      if (!inside[l] || joined[part] || (is_hole(loops.vertices[l]) && !whole[part])) continue;
      mark_enclosed(loops.vertices[l], part);
    }
  }

  bool is_hole(const std::vector<int>& loop) const {
    Ring ring;
    for (const int vertex : loop) ring.push_back(mesh_.points[vertex]);
    return signed_area(ring) < 0;
  }

  bool inside_lower_part(int vertex, int part) {
    gather(vertex);
    return std::any_of(local_.begin(), local_.end(), [&](const LocalNode& entry) {
      return entry.rank < part && !on_outline(entry.node);
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

  const Rule* rule_for(const LocalNode& lower, const LocalNode& upper, int vertex) const {
    for (const Rule& rule : rules_)
      if (uses(upper.node, rule.upper) && uses(lower.node, rule.lower) &&
          (!rule.limited || std::binary_search(rule.vertices.begin(), rule.vertices.end(), vertex)))
        return &rule;
    return nullptr;
  }

  void propose(int vertex) {
    candidates_.clear();
    for (size_t b = 1; b < local_.size(); ++b) {
      bool nearest = true;  // no inner node below this outline was met yet
      for (size_t a = b; a-- > 0;) {
        const bool inner = !on_outline(local_[a].node);
        propose_pair(static_cast<int>(a), static_cast<int>(b), vertex, nearest);
        nearest = nearest && !inner;
      }
    }
  }

  void propose_pair(int a, int b, int vertex, bool nearest) {
    const LocalNode& lower = local_[a];
    const LocalNode& upper = local_[b];
    const bool lower_outline = on_outline(lower.node);
    const bool upper_outline = on_outline(upper.node);
    const bool flap = role(lower.node) == NodeRole::flap || role(upper.node) == NodeRole::flap;
    if (lower_outline == upper_outline && (lower_outline || !flap)) return;
    const Rule* rule = rule_for(lower, upper, vertex);
    if (rule != nullptr && rule->kind == RelationKind::free) return;
    const Sense sense = sense_of(rule, lower, upper, vertex);
    if (sense == Sense::mixed) return;
    const bool glued = glued_below_[upper.node] == lower.node;
    const bool tied = rule != nullptr ? is_tie(rule->kind) : glued || enclosed_[upper.node];
    const bool swapped = sense == Sense::swapped;
    candidates_.push_back(
        {a, b, tied && !swapped && upper_outline && nearest, swapped, upper_outline});
  }

  // As said of the place, or else as the faces around it lie.
  Sense sense_of(const Rule* rule, const LocalNode& lower, const LocalNode& upper,
                 int vertex) const {
    if (rule != nullptr && rule->limited)
      return rule->kind == RelationKind::below ? Sense::swapped : Sense::usual;
    return sense_at(mesh_, order_, vertex, lower.rank, upper.rank);
  }

  // Keeps the most important candidates that close no cycle: equalities, what goes against the
  // order, then close pairs.
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
  const LocalOrder& order_;
  std::vector<Rule> rules_;
  std::vector<int> glued_below_;  // per node, or -1
  std::vector<bool> enclosed_;    // per node
  std::vector<LocalNode> local_;
  std::vector<NodeUse> uses_;
  std::vector<Candidate> candidates_;
  std::vector<DepthPair> pairs_;
};

bool may_pass(const Scene& scene, int front, int back) {
  const int lower = std::min(front, back);
  const int upper = std::max(front, back);
  return std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& relation) {
    return relation.kind == RelationKind::free && !relation.range && relation.upper == upper &&
           relation.lower == lower;
  });
}

/// The face on which the front one over triangle `t` may rest, or -1.
int support(const LayeredMesh& mesh, const Scene& scene, size_t t) {
  const int front = mesh.stack_begin[t + 1] - 1;
  for (int f = front - 1; f >= mesh.stack_begin[t]; --f)
    if (mesh.flap(f) == Flap::none && !may_pass(scene, mesh.face_part[front], mesh.face_part[f]))
      return f;
  return -1;
}

}  // namespace

std::vector<DepthPair> collect_constraints(const SheetMesh& mesh, const Boundaries& boundaries,
                                           const Scene& scene,
                                           const std::vector<LoopRun>& relation_runs,
                                           const LocalOrder& order) {
  return Collector(mesh, boundaries, order, rules_of(scene, relation_runs, mesh.loops)).run();
}

std::vector<DepthPair> resting_pairs(const LayeredMesh& mesh, const Scene& scene) {
  std::vector<DepthPair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int front = mesh.stack_begin[t + 1] - 1;
    if (front <= mesh.stack_begin[t] || scene.parts[mesh.face_part[front]].d < 0) continue;
    const int below = support(mesh, scene, t);
    if (below < 0) continue;
    for (int k = 0; k < 3; ++k) {
      const DepthPair pair{mesh.faces[below][k], mesh.faces[front][k], false};
      if (pair.lower != pair.upper && is_inside(mesh.node_role[pair.lower]) &&
          is_inside(mesh.node_role[pair.upper]))
        pairs.push_back(pair);
    }
  }
  const auto key = [](const DepthPair& pair) { return std::tie(pair.lower, pair.upper); };
  std::sort(pairs.begin(), pairs.end(),
            [&](const DepthPair& a, const DepthPair& b) { return key(a) < key(b); });
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace relievo::relief
