#include "relief/layers/flaps.h"

#include <cstdint>

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

/// Marks the faces behind the upper part of a join; loose ones stay loose.
void mark_behind(const SheetMesh& mesh, const LocalOrder& order, const Seam& seam, Flap kind,
                 std::vector<Flap>& flap) {
  std::vector<uint8_t> reached(mesh.faces.size(), 0);
  std::vector<int> pending;
  const auto take = [&](int face) {
    if (face < 0 || reached[face] != 0 || mesh.face_part[face] >= seam.upper) return;
    const int cover = mesh.face_of(mesh.face_triangle[face], seam.upper);
    if (cover < 0 || (!order.is_usual() && order.place[face] >= order.place[cover])) return;
    reached[face] = 1;
    if (flap[face] != Flap::loose) flap[face] = kind;
    pending.push_back(face);
  };
  for (const int face : seam.covered) take(face);
  while (!pending.empty()) {
    const int face = pending.back();
    pending.pop_back();
    for (int k = 0; k < 3; ++k) take(mesh.face_across(face, k));
  }
}

/// Flags the nodes whose surface, without loose flaps, has an outline, #N.
std::vector<uint8_t> nodes_with_outline(const SheetMesh& mesh, const std::vector<NodeRole>& role,
                                        const std::vector<Flap>& flap) {
  const int nodes = static_cast<int>(role.size());
  DisjointSets pieces(nodes);
  for (size_t f = 0; f < flap.size(); ++f)
    if (flap[f] != Flap::loose)
      for (const int k : {1, 2}) pieces.unite(mesh.faces[f][0], mesh.faces[f][k]);
  std::vector<uint8_t> fixed(role.size(), 0);
  for (int n = 0; n < nodes; ++n)
    if (role[n] == NodeRole::outline || role[n] == NodeRole::ramp) fixed[pieces.find(n)] = 1;
  for (int n = 0; n < nodes; ++n) fixed[n] = fixed[pieces.find(n)];
  return fixed;
}

/// Keeps the loose flaps that are connected to a face. Returns whether there were any.
bool keep_around(const SheetMesh& mesh, int face, std::vector<Flap>& flap) {
  bool any = false;
  std::vector<int> pending = {face};
  while (!pending.empty()) {
    const int at = pending.back();
    pending.pop_back();
    for (int k = 0; k < 3; ++k) {
      const int next = mesh.face_across(at, k);
      if (next < 0 || flap[next] != Flap::loose) continue;
      flap[next] = Flap::kept;
      any = true;
      pending.push_back(next);
    }
  }
  return any;
}

}  // namespace

std::vector<Flap> find_flaps(const SheetMesh& mesh, const std::vector<NodeRole>& role,
                             const LocalOrder& order, const Scene& scene, bool loose) {
  std::vector<Flap> flap(mesh.faces.size(), Flap::none);
  for (const Seam& seam : mesh.seams)
    mark_behind(mesh, order, seam,
                loose && has_one_sign(mesh, scene, seam.upper) ? Flap::loose : Flap::kept, flap);
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<uint8_t> fixed = nodes_with_outline(mesh, role, flap);
    for (int f = 0; f < static_cast<int>(flap.size()); ++f)
      if (flap[f] != Flap::loose && fixed[mesh.faces[f][0]] == 0)
        changed = keep_around(mesh, f, flap) || changed;
  }
  return flap;
}

}  // namespace relievo::relief
