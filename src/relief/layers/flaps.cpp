#include "relief/layers/flaps.h"

#include <utility>

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

class FlapFinder {
 public:
  FlapFinder(const SheetMesh& mesh, const LocalOrder& order)
      : mesh_(mesh), order_(order), flap_(mesh.faces.size(), Flap::none) {}

  void add(const Seam& seam, Flap kind) {
    reached_.assign(mesh_.faces.size(), 0);
    for (const int face : seam.covered) take(face, seam.upper, kind);
    while (!pending_.empty()) {
      const int face = pending_.back();
      pending_.pop_back();
      for (int k = 0; k < 3; ++k) take(mesh_.face_across(face, k), seam.upper, kind);
    }
  }

  /// What is left of a sheet may have no outline of its own: then the flaps that it hangs together
  /// with stay with it.
  void release(const std::vector<NodeRole>& role) {
    for (bool released = true; released;) {
      released = false;
      const std::vector<uint8_t> held = held_nodes(role);
      for (int f = 0; f < static_cast<int>(flap_.size()); ++f)
        if (flap_[f] != Flap::loose && held[mesh_.faces[f][0]] == 0)
          released = release_around(f) || released;
    }
  }

  std::vector<Flap> result() { return std::move(flap_); }

 private:
  bool lies_behind(int face, int other) const {
    return order_.is_usual() || order_.place[face] < order_.place[other];
  }

  void take(int face, int upper, Flap kind) {
    if (face < 0 || reached_[face] != 0 || mesh_.face_part[face] >= upper) return;
    const int cover = mesh_.face_of(mesh_.face_triangle[face], upper);
    if (cover < 0 || !lies_behind(face, cover)) return;
    reached_[face] = 1;
    if (flap_[face] != Flap::loose) flap_[face] = kind;
    pending_.push_back(face);
  }

  /// #N: whether the surface of the node has an outline.
  std::vector<uint8_t> held_nodes(const std::vector<NodeRole>& role) const {
    const int nodes = static_cast<int>(role.size());
    DisjointSets pieces(nodes);
    for (size_t f = 0; f < flap_.size(); ++f)
      if (flap_[f] != Flap::loose)
        for (const int k : {1, 2}) pieces.unite(mesh_.faces[f][0], mesh_.faces[f][k]);
    std::vector<uint8_t> held(role.size(), 0);
    for (int n = 0; n < nodes; ++n)
      if (role[n] == NodeRole::outline || role[n] == NodeRole::ramp) held[pieces.find(n)] = 1;
    for (int n = 0; n < nodes; ++n) held[n] = held[pieces.find(n)];
    return held;
  }

  /// Takes the flap across the edges of a face back; whether there is one.
  bool release_around(int face) {
    bool any = false;
    pending_.push_back(face);
    while (!pending_.empty()) {
      const int at = pending_.back();
      pending_.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int next = mesh_.face_across(at, k);
        if (next < 0 || flap_[next] != Flap::loose) continue;
        flap_[next] = Flap::kept;
        any = true;
        pending_.push_back(next);
      }
    }
    return any;
  }

  const SheetMesh& mesh_;
  const LocalOrder& order_;
  std::vector<Flap> flap_;        // per face
  std::vector<uint8_t> reached_;  // per face, by the flap of the seam at hand
  std::vector<int> pending_;
};

}  // namespace

std::vector<Flap> find_flaps(const SheetMesh& mesh, const Boundaries& boundaries,
                             const LocalOrder& order, const Scene& scene, bool loose) {
  FlapFinder finder(mesh, order);
  for (const Seam& seam : mesh.seams)
    finder.add(seam, loose && has_one_sign(mesh, scene, seam.upper) ? Flap::loose : Flap::kept);
  finder.release(boundaries.role);
  return finder.result();
}

}  // namespace relievo::relief
