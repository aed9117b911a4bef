#include "relief/ordering/depth_contacts.h"

#include <algorithm>

#include "kernel/geometry/nearest_mark.h"

namespace relievo {
namespace {

DepthContact contact_at(const LayeredMesh& mesh, const DepthGap& gap, bool closed) {
  const int lower = gap.sign > 0 ? gap.parent : gap.child;
  const int upper = gap.sign > 0 ? gap.child : gap.parent;
  return {mesh.node_part[lower], mesh.node_part[upper], mesh.vertices[mesh.node_vertex[lower]],
          closed};
}

}  // namespace

std::vector<DepthContact> contacts_of(const LayeredMesh& mesh, const DepthSystem& system) {
  std::vector<DepthContact> contacts;
  const DepthProblem& problem = system.problem;
  contacts.reserve(problem.forest.gaps.size());
  for (const DepthGap& gap : problem.forest.gaps) {
    const bool closed = system.closed[problem.variables.variable[gap.child]] != 0;
    contacts.push_back(contact_at(mesh, gap, closed));
  }
  return contacts;
}

std::vector<uint8_t> gaps_like(const LayeredMesh& mesh, const DepthProblem& problem,
                               std::vector<DepthContact> contacts) {
  std::sort(contacts.begin(), contacts.end(), [](const DepthContact& a, const DepthContact& b) {
    return std::pair(mark_key(a), a.closed) < std::pair(mark_key(b), b.closed);
  });
  std::vector<uint8_t> closed(problem.variables.bounded.size(), 0);
  for (const DepthGap& gap : problem.forest.gaps) {
    const DepthContact* contact = nearest_mark(contacts, contact_at(mesh, gap, false));
    closed[problem.variables.variable[gap.child]] = contact != nullptr && contact->closed;
  }
  return closed;
}

}  // namespace relievo
