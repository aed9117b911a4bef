#include "relief/joint/recall.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/nearest_mark.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

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

/// Between the two marks on outlines that are next to a place, one on either side of it.
struct Between {
  const JointMark* near = nullptr;  ///< null where the part has none
  const JointMark* beyond = nullptr;
  double share = 0;  ///< of the latter

  template <class Value>
  double of(const Value& value) const {
    return value(*near) + share * (value(*beyond) - value(*near));
  }
};

Between marks_around(const std::vector<JointMark>& marks, const JointMark& place) {
  const auto on_outline = [](const JointMark& mark) { return mark.on_outline; };
  Between between;
  between.near = between.beyond = nearest_mark(marks, place, on_outline);
  if (between.near == nullptr) return between;
  const Point2 offset = place.position - between.near->position;
  const double distance = std::sqrt(dot(offset, offset));
  if (distance == 0) return between;
  const JointMark* beyond = nearest_mark(marks, place, [&](const JointMark& mark) {
    return mark.on_outline && dot(mark.position - place.position, offset) > 0;
  });
  if (beyond == nullptr) return between;
  const Point2 rest = beyond->position - place.position;
  between.beyond = beyond;
  between.share = distance / (distance + std::sqrt(dot(rest, rest)));
  return between;
}

void recall_bound(const LayeredMesh& mesh, const JointModel& model,
                  const std::vector<JointMark>& marks, JointState& state) {
  for (const int n : model.bound) {
    const Between between = marks_around(marks, place_of(mesh, n));
    if (between.near == nullptr) continue;
    const double u = state.u[n] + between.of([](const JointMark& mark) { return mark.rise; });
    state.u[n] = model.sign[n] * u < 0 ? 0 : u;
  }
}

}  // namespace

void sort_marks(std::vector<JointMark>& marks) {
  std::stable_sort(marks.begin(), marks.end(), [](const JointMark& a, const JointMark& b) {
    return mark_key(a) < mark_key(b);
  });
}

std::vector<JointMark> remember(const LayeredMesh& mesh, const JointModel& model,
                                const std::vector<DepthPair>& pairs, const VectorXd& u_start,
                                const JointState& state) {
  std::vector<JointMark> marks;
  for (const int n : pressed_nodes(model, pairs)) {
    JointMark mark = place_of(mesh, n);
    mark.on_outline = model.place[n] < 0;
    mark.rise = state.u[n] - u_start[n];
    mark.load = state.load[n];
    marks.push_back(mark);
  }
  sort_marks(marks);
  return marks;
}

void remember(const LayeredMesh& mesh, const JointModel& model, const BoundModes& modes,
              JointMemory& memory) {
  if (modes.empty()) return;
  memory.mode_stiffness.assign(modes.stiffness.begin(), modes.stiffness.end());
  for (size_t i = 0; i < model.bound.size(); ++i) {
    const JointMark place = place_of(mesh, model.bound[i]);
    const auto [first, last] = std::equal_range(
        memory.marks.begin(), memory.marks.end(), place,
        [](const JointMark& a, const JointMark& b) { return mark_key(a) < mark_key(b); });
    const auto row = modes.values.row(static_cast<Eigen::Index>(i));
    for (auto mark = first; mark != last; ++mark)
      if (mark->on_outline) mark->modes.assign(row.begin(), row.end());
  }
}

BoundModes recall_modes(const LayeredMesh& mesh, const JointModel& model,
                        const JointMemory& known) {
  const auto count = static_cast<Eigen::Index>(known.mode_stiffness.size());
  BoundModes modes;
  modes.stiffness = Eigen::Map<const VectorXd>(known.mode_stiffness.data(), count);
  modes.values.setZero(static_cast<Eigen::Index>(model.bound.size()), count);
  for (size_t i = 0; i < model.bound.size(); ++i) {
    const Between between = marks_around(known.marks, place_of(mesh, model.bound[i]));
    if (between.near == nullptr) continue;
    for (Eigen::Index k = 0; k < count; ++k)
      modes.values(static_cast<Eigen::Index>(i), k) = between.of([&](const JointMark& mark) {
        return k < static_cast<Eigen::Index>(mark.modes.size()) ? mark.modes[k] : 0;
      });
  }
  return modes;
}

void recall(const LayeredMesh& mesh, const JointModel& model, const std::vector<DepthPair>& pairs,
            const std::vector<JointMark>& marks, JointState& state) {
  if (marks.empty()) return;
  recall_bound(mesh, model, marks, state);
  const std::vector<int> nodes = pressed_nodes(model, pairs);
  std::vector<const JointMark*> nearest;
  VectorXd shared = VectorXd::Zero(static_cast<Eigen::Index>(marks.size()));
  for (const int n : nodes) {
    nearest.push_back(nearest_mark(marks, place_of(mesh, n)));
    if (nearest.back() != nullptr) shared[nearest.back() - marks.data()] += model.mass[n];
  }
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nearest[i] == nullptr) continue;
    const int n = nodes[i];
    state.load[n] = nearest[i]->load * model.mass[n] / shared[nearest[i] - marks.data()];
  }
}

}  // namespace relievo
