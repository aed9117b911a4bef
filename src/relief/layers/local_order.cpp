#include "relief/layers/local_order.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

namespace relievo::relief {
namespace {

/// The range of a relation as it lies on the mesh.
struct Range {
  int relation;
  int upper;
  int lower;
  std::vector<int> vertices;  // in its direction
};

struct PartPair {
  int upper;
  int lower;
  friend bool operator==(const PartPair&, const PartPair&) = default;
};

class Finder {
 public:
  Finder(const SheetMesh& mesh, const Scene& scene) : mesh_(mesh), scene_(scene) {}

  Result<LocalOrder> run(const std::vector<LoopRun>& runs) {
    find_ranges(runs);
    if (below_.empty()) return std::move(order_);
    order_.faces.resize(mesh_.faces.size());
    std::iota(order_.faces.begin(), order_.faces.end(), 0);
    order_.place = order_.faces;
    // From back to front: what a part is put behind lies in its place already.
    for (const PartPair pair : pairs_below()) swap(pair);
    if (Status status = check_senses(); !status) return status.error();
    return std::move(order_);
  }

 private:
  void find_ranges(const std::vector<LoopRun>& runs) {
    for (size_t r = 0; r < runs.size(); ++r) {
      const Relation& relation = scene_.relations[r];
      const bool below = relation.kind == RelationKind::below;
      if (runs[r].loop < 0 || (!below && relation.kind != RelationKind::above)) continue;
      (below ? below_ : above_)
          .push_back({static_cast<int>(r), relation.upper, relation.lower,
                      run_vertices(mesh_.loops, runs[r])});
    }
  }

  std::vector<PartPair> pairs_below() const {
    std::vector<PartPair> pairs;
    for (const Range& range : below_) pairs.push_back({range.upper, range.lower});
    std::sort(pairs.begin(), pairs.end(), [](PartPair a, PartPair b) {
      return a.upper != b.upper ? a.upper < b.upper : a.lower < b.lower;
    });
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  bool is_inside(int vertex, int part) const {
    const std::span<const Corner> corners = mesh_.base_corners.at(vertex);
    return std::all_of(corners.begin(), corners.end(),
                       [&](Corner c) { return mesh_.face_of(triangle_of(c), part) >= 0; });
  }

  bool overlap_at(int triangle, PartPair pair) const {
    return mesh_.face_of(triangle, pair.upper) >= 0 && mesh_.face_of(triangle, pair.lower) >= 0;
  }

  void swap(PartPair pair) {
    std::vector<int> queue;
    std::vector<int> sense = senses_at_outline(pair, queue);
    for (size_t i = 0; i < queue.size(); ++i)
      for (const int next : mesh_.base.neighbours[queue[i]]) {
        if (next < 0 || sense[next] != 0 || !overlap_at(next, pair)) continue;
        sense[next] = sense[queue[i]];
        queue.push_back(next);
      }
    for (const int triangle : queue)
      if (sense[triangle] < 0) put_behind(triangle, pair);
  }

  // Per triangle that has a corner on the upper outline inside the lower part: 1 or -1; listed in
  // `queue`.
  std::vector<int> senses_at_outline(PartPair pair, std::vector<int>& queue) const {
    std::vector<uint8_t> behind(mesh_.points.size(), 0);
    for (const Range& range : below_)
      if (PartPair{range.upper, range.lower} == pair)
        for (const int vertex : range.vertices) behind[vertex] = 1;
    std::vector<int> votes(mesh_.base.triangles.size(), 0);
    for (size_t l = 0; l < mesh_.loops.vertices.size(); ++l) {
      if (mesh_.loops.part[l] != pair.upper) continue;
      for (const int vertex : mesh_.loops.vertices[l]) {
        if (!is_inside(vertex, pair.lower)) continue;
        for (const Corner corner : mesh_.base_corners.at(vertex)) {
          const int triangle = triangle_of(corner);
          if (mesh_.face_of(triangle, pair.upper) < 0) continue;
          queue.push_back(triangle);
          votes[triangle] += behind[vertex] != 0 ? -1 : 1;
        }
      }
    }
    std::sort(queue.begin(), queue.end());
    queue.erase(std::unique(queue.begin(), queue.end()), queue.end());
    for (const int triangle : queue) votes[triangle] = votes[triangle] < 0 ? -1 : 1;
    return votes;
  }

  // Moves the face of the upper part just behind that of the lower one, if it is not behind yet.
  void put_behind(int triangle, PartPair pair) {
    const int from = order_.place[mesh_.face_of(triangle, pair.upper)];
    const int to = order_.place[mesh_.face_of(triangle, pair.lower)];
    if (from < to) return;
    const auto faces = order_.faces.begin();
    std::rotate(faces + to, faces + from, faces + from + 1);
    for (int i = to; i <= from; ++i) order_.place[order_.faces[i]] = i;
  }

  // A part cannot be behind one and in front of the same, or of another that covers it.
  Status check_senses() const {
    for (const Range& below : below_)
      for (const Range& above : above_) {
        if (above.upper != below.upper || above.lower < below.lower) continue;
        for (const int vertex : below.vertices)
          if (contradict(below, above, vertex)) return contradiction(below, above);
      }
    return Done{};
  }

  bool contradict(const Range& below, const Range& above, int vertex) const {
    const auto ends_at = [&](const Range& range) {
      return range.vertices.front() == vertex || range.vertices.back() == vertex;
    };
    if (std::find(above.vertices.begin(), above.vertices.end(), vertex) == above.vertices.end())
      return false;
    if (ends_at(below) && ends_at(above)) return false;
    if (!is_inside(vertex, below.lower) || !is_inside(vertex, above.lower)) return false;
    return above.lower == below.lower ||
           sense_at(mesh_, order_, vertex, below.lower, above.lower) == Sense::usual;
  }

  Error contradiction(const Range& below, const Range& above) const {
    const auto id = [&](int part) { return "\"" + scene_.parts[part].id + "\""; };
    const auto relation = [](const Range& range) {
      return Culprit{CulpritList::relations, static_cast<size_t>(range.relation)};
    };
    return {ErrorCode::contradiction,
            "puts " + id(below.upper) + " behind " + id(below.lower) + " where " +
                to_string(relation(above)) + " puts it in front of " + id(above.lower) +
                (above.lower == below.lower ? "" : ", which covers that") +
                "; give them ranges that do not overlap",
            to_string(relation(below)), relation(below)};
  }

  const SheetMesh& mesh_;
  const Scene& scene_;
  std::vector<Range> below_;
  std::vector<Range> above_;
  LocalOrder order_;
};

}  // namespace

std::vector<int> run_vertices(const Loops& loops, const LoopRun& run) {
  const std::vector<int>& loop = loops.vertices[run.loop];
  std::vector<int> vertices;
  for (int i = 0; i <= run.edges; ++i) vertices.push_back(loop[(run.position + i) % loop.size()]);
  return vertices;
}

Result<LocalOrder> find_local_order(const SheetMesh& mesh, const Scene& scene,
                                    const std::vector<LoopRun>& runs) {
  return Finder(mesh, scene).run(runs);
}

Sense sense_at(const SheetMesh& mesh, const LocalOrder& order, int vertex, int lower, int upper) {
  if (order.is_usual()) return Sense::usual;
  bool usual = false;
  bool swapped = false;
  for (const Corner corner : mesh.base_corners.at(vertex)) {
    const int below = mesh.face_of(triangle_of(corner), lower);
    const int above = mesh.face_of(triangle_of(corner), upper);
    if (below < 0 || above < 0) continue;
    (order.place[below] < order.place[above] ? usual : swapped) = true;
  }
  if (usual && swapped) return Sense::mixed;
  return swapped ? Sense::swapped : Sense::usual;
}

}  // namespace relievo::relief
