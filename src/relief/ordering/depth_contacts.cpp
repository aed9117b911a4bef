// Active sets that outlive a mesh. A gap z_child >= 0 is in the first active set if the depth pair
// nearest to it, of the same two parts, had h_upper <= h_lower in an earlier solution.

#include "relief/ordering/depth_contacts.h"

#include <algorithm>
#include <utility>

#include "kernel/geometry/nearest_mark.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

DepthContact contact_at(const LayeredMesh& mesh, int lower, int upper) {
  return {mesh.node_part[lower], mesh.node_part[upper],
          is_inside(mesh.node_role[lower]) && is_inside(mesh.node_role[upper]),
          mesh.vertices[mesh.node_vertex[lower]], false};
}

void sort_contacts(std::vector<DepthContact>& contacts) {
  std::sort(contacts.begin(), contacts.end(), [](const DepthContact& a, const DepthContact& b) {
    return std::pair(mark_key(a), a.closed) < std::pair(mark_key(b), b.closed);
  });
}

bool closed_nearby(const std::vector<DepthContact>& contacts, const DepthContact& place) {
  const DepthContact* contact = nearest_mark(contacts, place);
  return contact != nullptr && contact->closed;
}

}  // namespace

std::vector<DepthContact> contacts_of(const LayeredMesh& mesh, const std::vector<double>& h) {
  std::vector<DepthContact> contacts;
  for (const DepthPair& pair : mesh.constraints) {
    if (pair.equal) continue;
    contacts.push_back(contact_at(mesh, pair.lower, pair.upper));
    contacts.back().closed = h[pair.upper] <= h[pair.lower];
  }
  return contacts;
}

std::vector<uint8_t> gaps_like(const LayeredMesh& mesh, const DepthForest& forest,
                               std::vector<DepthContact> contacts) {
  sort_contacts(contacts);
  std::vector<uint8_t> closed(forest.group.size(), 0);
  for (const DepthGap& gap : forest.gaps) {
    const int lower = gap.sign > 0 ? gap.parent : gap.child;
    const int upper = gap.sign > 0 ? gap.child : gap.parent;
    closed[gap.child] = closed_nearby(contacts, contact_at(mesh, lower, upper));
  }
  return closed;
}

}  // namespace relievo::relief
