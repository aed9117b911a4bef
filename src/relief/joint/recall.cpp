#include "relief/joint/recall.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/nearest_mark.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

template <class Mark>
void sort_marks(std::vector<Mark>& marks) {
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return mark_key(a) < mark_key(b); });
}

/// The nodes of pairs and of B, ascending.
std::vector<int> pressed_nodes(const JointModel& model, const std::vector<DepthPair>& pairs) {
  std::vector<int> nodes = model.bound;
  for (const DepthPair& pair : pairs) {
    nodes.push_back(pair.lower);
    nodes.push_back(pair.upper);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

JointMark place_of(const LayeredMesh& mesh, int node) {
  JointMark mark;
  mark.part = mesh.node_part[node];
  mark.position = mesh.vertices[mesh.node_vertex[node]];
  return mark;
}

InnerContact contact_of(const LayeredMesh& mesh, const DepthPair& pair) {
  InnerContact contact;
  contact.lower = mesh.node_part[pair.lower];
  contact.upper = mesh.node_part[pair.upper];
  contact.position = mesh.vertices[mesh.node_vertex[pair.lower]];
  return contact;
}

/// The longest edge at each node, px.
std::vector<double> longest_edges(const LayeredMesh& mesh) {
  std::vector<double> longest(mesh.node_vertex.size(), 0);
  for (const auto& face : mesh.faces)
    for (int k = 0; k < 3; ++k) {
      const int a = face[k];
      const int b = face[(k + 1) % 3];
      const Point2 edge = mesh.vertices[mesh.node_vertex[b]] - mesh.vertices[mesh.node_vertex[a]];
      const double length = std::sqrt(dot(edge, edge));
      longest[a] = std::max(longest[a], length);
      longest[b] = std::max(longest[b], length);
    }
  return longest;
}

/// The pairs that were added to those of the mesh, where the parts touch.
std::vector<InnerContact> inner_contacts(const LayeredMesh& mesh,
                                         const std::vector<DepthPair>& pairs,
                                         const std::vector<double>& h) {
  std::vector<InnerContact> contacts;
  if (pairs.size() == mesh.constraints.size()) return contacts;
  const std::vector<double> reach = longest_edges(mesh);
  for (size_t i = mesh.constraints.size(); i < pairs.size(); ++i) {
    if (h[pairs[i].upper] > h[pairs[i].lower]) continue;
    contacts.push_back(contact_of(mesh, pairs[i]));
    contacts.back().reach = reach[pairs[i].lower];
  }
  return contacts;
}

}  // namespace

void sort_memory(JointMemory& memory) {
  sort_marks(memory.marks);
  sort_marks(memory.contacts);
}

JointMemory remember(const LayeredMesh& mesh, const JointModel& model,
                     const std::vector<DepthPair>& pairs, const VectorXd& u_start,
                     const JointState& state) {
  JointMemory memory;
  for (const int n : pressed_nodes(model, pairs)) {
    JointMark mark = place_of(mesh, n);
    mark.rise = state.u[n] - u_start[n];
    mark.load = state.load[n];
    mark.h = state.h[n];
    memory.marks.push_back(mark);
  }
  memory.contacts = inner_contacts(mesh, pairs, state.h);
  sort_memory(memory);
  return memory;
}

std::vector<DepthPair> likely_pairs(const LayeredMesh& mesh, const StackedNodes& stacked,
                                    const std::vector<InnerContact>& contacts) {
  if (contacts.empty()) return {};
  std::vector<DepthPair> pairs = stacked.pairs;
  const auto apart = [&](const DepthPair& pair) {
    const InnerContact place = contact_of(mesh, pair);
    const InnerContact* contact = nearest_mark(contacts, place);
    if (contact == nullptr) return true;
    const Point2 offset = contact->position - place.position;
    return dot(offset, offset) > contact->reach * contact->reach;
  };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), apart), pairs.end());
  return pairs;
}

void recall(const LayeredMesh& mesh, const JointModel& model, const std::vector<DepthPair>& pairs,
            const std::vector<JointMark>& marks, JointState& state) {
  if (marks.empty()) return;
  const std::vector<int> nodes = pressed_nodes(model, pairs);
  std::vector<const JointMark*> nearest;
  VectorXd shared = VectorXd::Zero(static_cast<Eigen::Index>(marks.size()));
  for (const int n : nodes) {
    nearest.push_back(nearest_mark(marks, place_of(mesh, n)));
    if (nearest.back() != nullptr) shared[nearest.back() - marks.data()] += model.mass[n];
  }
  state.h.assign(mesh.node_vertex.size(), 0);
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nearest[i] == nullptr) continue;
    const int n = nodes[i];
    state.h[n] = nearest[i]->h;
    const double u = state.u[n] + nearest[i]->rise;
    state.u[n] = model.sign[n] * u < 0 ? 0 : u;
    state.load[n] = nearest[i]->load * model.mass[n] / shared[nearest[i] - marks.data()];
  }
}

}  // namespace relievo
