#include "relief/ordering/depth_contacts.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace relievo {
namespace {

auto key(const DepthContact& contact) {
  return std::tie(contact.lower, contact.upper, contact.position.x, contact.position.y,
                  contact.closed);
}

bool same_parts(const DepthContact& a, const DepthContact& b) {
  return a.lower == b.lower && a.upper == b.upper;
}

DepthContact contact_at(const LayeredMesh& mesh, const DepthGap& gap, bool closed) {
  const int lower = gap.sign > 0 ? gap.parent : gap.child;
  const int upper = gap.sign > 0 ? gap.child : gap.parent;
  return {mesh.node_part[lower], mesh.node_part[upper], mesh.vertices[mesh.node_vertex[lower]],
          closed};
}

/// Whether the nearest contact of the same parts is closed; `contacts` are sorted by key.
bool nearest_is_closed(const std::vector<DepthContact>& contacts, const DepthContact& gap) {
  const auto at = std::lower_bound(
      contacts.begin(), contacts.end(), gap,
      [](const DepthContact& a, const DepthContact& b) { return key(a) < key(b); });
  double least = std::numeric_limits<double>::infinity();
  bool closed = false;
  const auto look = [&](const DepthContact& contact) {
    if (!same_parts(contact, gap)) return false;
    const Point2 offset = contact.position - gap.position;
    if (offset.x * offset.x >= least) return false;
    if (dot(offset, offset) < least) {
      least = dot(offset, offset);
      closed = contact.closed;
    }
    return true;
  };
  for (auto right = at; right != contacts.end() && look(*right);) ++right;
  for (auto left = at; left != contacts.begin() && look(*(left - 1));) --left;
  return closed;
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
  std::sort(contacts.begin(), contacts.end(),
            [](const DepthContact& a, const DepthContact& b) { return key(a) < key(b); });
  std::vector<uint8_t> closed(problem.variables.bounded.size(), 0);
  for (const DepthGap& gap : problem.forest.gaps)
    closed[problem.variables.variable[gap.child]] =
        nearest_is_closed(contacts, contact_at(mesh, gap, false));
  return closed;
}

}  // namespace relievo
