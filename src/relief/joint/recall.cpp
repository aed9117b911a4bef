#include "relief/joint/recall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace relievo {
namespace {

auto key(const JointMark& mark) { return std::tie(mark.part, mark.position.x, mark.position.y); }

bool less(const JointMark& a, const JointMark& b) { return key(a) < key(b); }

/// The nodes of pairs and of B, ascending.
std::vector<int> pressed_nodes(const LayeredMesh& mesh, const JointModel& model) {
  std::vector<int> nodes = model.bound;
  for (const DepthPair& pair : mesh.constraints) {
    nodes.push_back(pair.lower);
    nodes.push_back(pair.upper);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Place of a node in B, -1 where it is not on it.
Eigen::Index place_in_bound(const JointModel& model, int node) {
  const auto at = std::lower_bound(model.bound.begin(), model.bound.end(), node);
  if (at == model.bound.end() || *at != node) return -1;
  return at - model.bound.begin();
}

JointMark place_of(const LayeredMesh& mesh, int node) {
  JointMark mark;
  mark.part = mesh.node_part[node];
  mark.position = mesh.vertices[mesh.node_vertex[node]];
  return mark;
}

/// The nearest mark of the same part, or null.
const JointMark* nearest(const JointMemory& memory, const JointMark& place) {
  const auto at = std::lower_bound(memory.begin(), memory.end(), place, less);
  double least = std::numeric_limits<double>::infinity();
  const JointMark* best = nullptr;
  const auto look = [&](const JointMark& mark) {
    const Point2 offset = mark.position - place.position;
    if (mark.part != place.part || offset.x * offset.x >= least) return false;
    if (dot(offset, offset) < least) {
      least = dot(offset, offset);
      best = &mark;
    }
    return true;
  };
  for (auto right = at; right != memory.end() && look(*right);) ++right;
  for (auto left = at; left != memory.begin() && look(*(left - 1));) --left;
  return best;
}

}  // namespace

JointMemory remember(const LayeredMesh& mesh, const JointModel& model,
                     const Eigen::VectorXd& u_start, const JointState& state) {
  JointMemory memory;
  for (const int n : pressed_nodes(mesh, model)) {
    JointMark mark = place_of(mesh, n);
    mark.rise = state.u[n] - u_start[n];
    mark.load = state.load[n] / std::sqrt(model.mass[n]);
    mark.h = state.h[n];
    const Eigen::Index i = place_in_bound(model, n);
    if (i >= 0) mark.slope = state.slope[i] / model.bound_mass[i];
    memory.push_back(mark);
  }
  std::stable_sort(memory.begin(), memory.end(), less);
  return memory;
}

void recall(const LayeredMesh& mesh, const JointModel& model, const JointMemory& memory,
            JointState& state) {
  if (memory.empty()) return;
  state.h.assign(mesh.node_vertex.size(), 0);
  for (const int n : pressed_nodes(mesh, model)) {
    const JointMark* mark = nearest(memory, place_of(mesh, n));
    if (mark == nullptr) continue;
    state.h[n] = mark->h;
    const Eigen::Index i = place_in_bound(model, n);
    if (i < 0 && model.place[n] < 0) continue;
    const double u = state.u[n] + mark->rise;
    state.u[n] = model.sign[n] * u < 0 ? 0 : u;
    if (model.sign[n] == 0) state.load[n] = mark->load * std::sqrt(model.mass[n]);
    if (i >= 0) state.slope[i] = mark->slope * model.bound_mass[i];
  }
}

}  // namespace relievo
