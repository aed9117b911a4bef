// Starts of the non-linear iteration from an earlier one, on any mesh:
//
//   u_n    <-  u_n + rise between the marks beside n on the outline       on B
//   phi_n  <-  phi_mark M_n / sum of M over the nodes nearest to the mark    at nodes of pairs and
//   B
//
//   letter    in the code
//   u, phi    NonlinearState::u, load
//   rise      NonlinearMark::rise
//   M         NonlinearModel::mass

#include "relief/nonlinear/recall.h"

#include <algorithm>
#include <optional>

#include "kernel/geometry/nearest_mark.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Returns the nodes of pairs and of B, ascending.
std::vector<int> marked_nodes(const NonlinearModel& model, const std::vector<DepthPair>& pairs) {
  std::vector<int> nodes = model.bound;
  for (const DepthPair& pair : pairs) {
    nodes.push_back(pair.lower);
    nodes.push_back(pair.upper);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

NonlinearMark mark_at(const LayeredMesh& mesh, int node) {
  NonlinearMark mark;
  mark.part = mesh.node_part[node];
  mark.position = mesh.vertices[mesh.node_vertex[node]];
  return mark;
}

/// Interpolates the rise between the nearest marks on outlines on both sides of `place`. Returns
/// nothing if the part has none.
std::optional<double> rise_at(const std::vector<NonlinearMark>& marks, const NonlinearMark& place) {
  const auto on_outline = [](const NonlinearMark& mark) { return mark.on_outline; };
  const auto beside = marks_beside(marks, place, on_outline);
  if (!beside) return std::nullopt;
  return beside->near->rise + beside->share * (beside->beyond->rise - beside->near->rise);
}

void recall_bound(const LayeredMesh& mesh, const NonlinearModel& model,
                  const std::vector<NonlinearMark>& marks, NonlinearState& state) {
  for (size_t i = 0; i < model.bound.size(); ++i) {
    const int n = model.bound[i];
    const double u = state.u[n] + rise_at(marks, mark_at(mesh, n)).value_or(0);
    state.u[n] = model.sign[n] * u < 0 && model.lifting_gap[i] < 0 ? 0 : u;
  }
}

}  // namespace

std::vector<NonlinearMark> remember(const LayeredMesh& mesh, const NonlinearModel& model,
                                    const std::vector<DepthPair>& pairs, const VectorXd& u_start,
                                    const NonlinearState& state) {
  std::vector<NonlinearMark> marks;
  for (const int n : marked_nodes(model, pairs)) {
    NonlinearMark mark = mark_at(mesh, n);
    mark.on_outline = model.inner_index[n] < 0;
    mark.rise = state.u[n] - u_start[n];
    mark.load = state.load[n];
    marks.push_back(mark);
  }
  sort_marks(marks);
  return marks;
}

void recall(const LayeredMesh& mesh, const NonlinearModel& model,
            const std::vector<DepthPair>& pairs, const std::vector<NonlinearMark>& marks,
            NonlinearState& state) {
  if (marks.empty()) return;
  recall_bound(mesh, model, marks, state);
  const std::vector<int> nodes = marked_nodes(model, pairs);
  std::vector<const NonlinearMark*> nearest;
  VectorXd shared = VectorXd::Zero(static_cast<Eigen::Index>(marks.size()));
  for (const int n : nodes) {
    nearest.push_back(nearest_mark(marks, mark_at(mesh, n)));
    if (nearest.back() != nullptr) shared[nearest.back() - marks.data()] += model.mass[n];
  }
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nearest[i] == nullptr) continue;
    const int n = nodes[i];
    state.load[n] = nearest[i]->load * model.mass[n] / shared[nearest[i] - marks.data()];
  }
}

}  // namespace relievo::relief
