#include "relief/layers/local_order.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>

namespace relievo::relief {
namespace {

bool is_of_same_parts(const PlacedRelation& a, const PlacedRelation& b) {
  return a.upper == b.upper && a.lower == b.lower;
}

/// Returns whether all triangles at a vertex belong to the part.
bool is_inside(const SheetMesh& mesh, int vertex, int part) {
  const std::span<const Corner> corners = mesh.base_corners.at(vertex);
  return std::all_of(corners.begin(), corners.end(),
                     [&](Corner c) { return mesh.face_of(triangle_of(c), part) >= 0; });
}

/// Lists the triangles of the overlap that have a corner on the upper outline inside the lower
/// part, ascending, and sets `sense` (#T) to -1 where more of these corners lie in ranges "below"
/// than not, or else to 1.
std::vector<int> triangles_at_outline(const SheetMesh& mesh, const PlacedRelation& pair,
                                      const std::vector<PlacedRelation>& below,
                                      std::vector<int>& sense) {
  std::vector<uint8_t> behind(mesh.points.size(), 0);
  for (const PlacedRelation& relation : below)
    if (is_of_same_parts(relation, pair))
      for (const int vertex : relation.vertices) behind[vertex] = 1;
  std::vector<int> triangles;
  for (size_t l = 0; l < mesh.loops.size(); ++l) {
    if (mesh.loop_part[l] != pair.upper) continue;
    for (const int vertex : mesh.loops[l]) {
      if (!is_inside(mesh, vertex, pair.lower)) continue;
      for (const Corner corner : mesh.base_corners.at(vertex)) {
        const int triangle = triangle_of(corner);
        if (mesh.face_of(triangle, pair.upper) < 0) continue;
        triangles.push_back(triangle);
        sense[triangle] += behind[vertex] != 0 ? -1 : 1;
      }
    }
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  for (const int triangle : triangles) sense[triangle] = sense[triangle] < 0 ? -1 : 1;
  return triangles;
}

/// Moves the face of the upper part over a triangle just behind that of the lower one, unless it is
/// behind it already.
void put_behind(const SheetMesh& mesh, int triangle, const PlacedRelation& pair,
                LocalOrder& order) {
  const int from = order.place[mesh.face_of(triangle, pair.upper)];
  const int to = order.place[mesh.face_of(triangle, pair.lower)];
  if (from < to) return;
  const auto faces = order.faces.begin();
  std::rotate(faces + to, faces + from, faces + from + 1);
  for (int i = to; i <= from; ++i) order.place[order.faces[i]] = i;
}

/// Spreads the senses at the outline over the overlap of two parts and reorders the stacks there.
void swap_parts(const SheetMesh& mesh, const PlacedRelation& pair,
                const std::vector<PlacedRelation>& below, LocalOrder& order) {
  std::vector<int> sense(mesh.base.triangles.size(), 0);
  std::vector<int> queue = triangles_at_outline(mesh, pair, below, sense);
  for (size_t i = 0; i < queue.size(); ++i)
    for (const int next : mesh.base.neighbours[queue[i]]) {
      if (next < 0 || sense[next] != 0) continue;
      if (mesh.face_of(next, pair.upper) < 0 || mesh.face_of(next, pair.lower) < 0) continue;
      sense[next] = sense[queue[i]];
      queue.push_back(next);
    }
  for (const int triangle : queue)
    if (sense[triangle] < 0) put_behind(mesh, triangle, pair, order);
}

/// Returns whether "below" and "above" contradict each other at a vertex of the former: a part
/// cannot be behind one and in front of the same, or of another that covers it.
bool contradict(const SheetMesh& mesh, const LocalOrder& order, const PlacedRelation& below,
                const PlacedRelation& above, int vertex) {
  const auto ends_at = [&](const PlacedRelation& relation) {
    return relation.vertices.front() == vertex || relation.vertices.back() == vertex;
  };
  if (std::find(above.vertices.begin(), above.vertices.end(), vertex) == above.vertices.end())
    return false;
  if (ends_at(below) && ends_at(above)) return false;
  if (!is_inside(mesh, vertex, below.lower) || !is_inside(mesh, vertex, above.lower)) return false;
  return above.lower == below.lower ||
         sense_at(mesh, order, vertex, below.lower, above.lower) == Sense::usual;
}

Error contradiction(const Scene& scene, const PlacedRelation& below, const PlacedRelation& above) {
  const auto id = [&](int part) { return "\"" + scene.parts[part].id + "\""; };
  const auto relation = [](const PlacedRelation& placed) {
    return Culprit{CulpritList::relations, static_cast<size_t>(placed.index)};
  };
  return {ErrorCode::contradiction,
          "puts " + id(below.upper) + " behind " + id(below.lower) + " where " +
              to_string(relation(above)) + " puts it in front of " + id(above.lower) +
              (above.lower == below.lower ? "" : ", which covers that") +
              "; give them ranges that do not overlap",
          to_string(relation(below)), relation(below)};
}

}  // namespace

std::vector<PlacedRelation> place_relations(const Scene& scene, const std::vector<LoopRun>& runs,
                                            const SheetMesh& mesh) {
  std::vector<PlacedRelation> placed;
  auto run = runs.begin();
  for (size_t r = 0; r < scene.relations.size(); ++r) {
    const Relation& relation = scene.relations[r];
    placed.push_back({static_cast<int>(r),
                      relation.upper,
                      relation.lower,
                      relation.kind,
                      relation.range.has_value(),
                      {}});
    if (!relation.range) continue;
    if (run->loop >= 0) placed.back().vertices = mesh.run_vertices(*run);
    ++run;
  }
  return placed;
}

Result<LocalOrder> find_local_order(const SheetMesh& mesh, const Scene& scene,
                                    const std::vector<PlacedRelation>& relations) {
  std::vector<PlacedRelation> below;
  std::vector<PlacedRelation> above;
  for (const PlacedRelation& relation : relations) {
    if (relation.vertices.empty()) continue;
    if (relation.kind == RelationKind::below) below.push_back(relation);
    if (relation.kind == RelationKind::above) above.push_back(relation);
  }
  LocalOrder order;
  if (below.empty()) return order;
  order.faces.resize(mesh.faces.size());
  std::iota(order.faces.begin(), order.faces.end(), 0);
  order.place = order.faces;
  // From back to front, so that the part that another is put behind is in its place already.
  std::vector<PlacedRelation> pairs = below;
  std::sort(pairs.begin(), pairs.end(), [](const PlacedRelation& a, const PlacedRelation& b) {
    return std::tie(a.upper, a.lower) < std::tie(b.upper, b.lower);
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end(), is_of_same_parts), pairs.end());
  for (const PlacedRelation& pair : pairs) swap_parts(mesh, pair, below, order);
  for (const PlacedRelation& one : below)
    for (const PlacedRelation& other : above) {
      if (other.upper != one.upper || other.lower < one.lower) continue;
      for (const int vertex : one.vertices)
        if (contradict(mesh, order, one, other, vertex)) return contradiction(scene, one, other);
    }
  return order;
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
