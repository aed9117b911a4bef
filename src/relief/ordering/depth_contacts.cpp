#include "relief/ordering/depth_contacts.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace relievo {
namespace {

auto kind(const DepthContact& contact) {
  return std::tie(contact.lower, contact.upper, contact.inside);
}

auto key(const DepthContact& contact) {
  return std::tuple_cat(kind(contact),
                        std::tie(contact.position.x, contact.position.y, contact.closed));
}

bool by_key(const DepthContact& a, const DepthContact& b) { return key(a) < key(b); }

bool inside(NodeRole role) { return role == NodeRole::interior || role == NodeRole::seam; }

DepthContact contact_at(const LayeredMesh& mesh, int lower, int upper) {
  return {mesh.node_part[lower], mesh.node_part[upper],
          inside(mesh.node_role[lower]) && inside(mesh.node_role[upper]),
          mesh.vertices[mesh.node_vertex[lower]], false};
}

}  // namespace

std::vector<DepthContact> contacts_of(const LayeredMesh& mesh, const StackedNodes& stacked,
                                      const std::vector<double>& h) {
  std::vector<DepthContact> contacts;
  const auto add = [&](const DepthPair& pair) {
    contacts.push_back(contact_at(mesh, pair.lower, pair.upper));
    contacts.back().closed = h[pair.upper] <= h[pair.lower];
  };
  for (const DepthPair& pair : mesh.constraints)
    if (!pair.equal) add(pair);
  std::vector<uint8_t> closed;
  closed.reserve(stacked.pairs.size());
  for (const DepthPair& pair : stacked.pairs) closed.push_back(h[pair.upper] <= h[pair.lower]);
  for (const DepthPair& pair : flagged(stacked, grown(stacked, std::move(closed), 1))) add(pair);
  return contacts;
}

ContactGuess::ContactGuess(std::vector<DepthContact> contacts) : contacts_(std::move(contacts)) {
  std::sort(contacts_.begin(), contacts_.end(), by_key);
}

bool ContactGuess::is_closed(const DepthContact& place) const {
  const auto at = std::lower_bound(contacts_.begin(), contacts_.end(), place, by_key);
  double least = std::numeric_limits<double>::infinity();
  bool closed = false;
  const auto look = [&](const DepthContact& contact) {
    if (kind(contact) != kind(place)) return false;
    const Point2 offset = contact.position - place.position;
    if (offset.x * offset.x >= least) return false;
    if (dot(offset, offset) < least) {
      least = dot(offset, offset);
      closed = contact.closed;
    }
    return true;
  };
  for (auto right = at; right != contacts_.end() && look(*right);) ++right;
  for (auto left = at; left != contacts_.begin() && look(*(left - 1));) --left;
  return closed;
}

std::vector<uint8_t> ContactGuess::closed_gaps(const LayeredMesh& mesh,
                                               const DepthProblem& problem) const {
  std::vector<uint8_t> closed(problem.variables.bounded.size(), 0);
  for (const DepthGap& gap : problem.forest.gaps) {
    const int lower = gap.sign > 0 ? gap.parent : gap.child;
    const int upper = gap.sign > 0 ? gap.child : gap.parent;
    closed[problem.variables.variable[gap.child]] = is_closed(contact_at(mesh, lower, upper));
  }
  return closed;
}

}  // namespace relievo
