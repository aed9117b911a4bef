// The depth order [P eq 12-13] with bounds only, in scene units:
//
//   minimise 1/2 (h - f)'A (h - f) - b'(h - f)    subject to h_lower <= h_upper, or equal
//
// Each node but the roots hangs on a parent, h_child = h_parent +- z_child, so h = T z and the
// pairs are z >= 0 or z = 0. With z counted from f0, the heights f of the roots and gaps 0,
//
//   minimise 1/2 z'K z - q'z,    K = T'A T,    q = T'(A d + b),    d = f - T f0
//
//   letter    in the code
//   A, b      ShiftMetric::A, b
//   T         DepthSystem::T
//   K, q      BoundQp::K, b
//   f0        root_heights
//   d         beyond_roots
//
// Active sets that outlive a mesh. A gap z_child >= 0 is in the first active set if the depth pair
// nearest to it, of the same two parts, had h_upper <= h_lower in an earlier solution.

#include "relief/ordering/depth_system.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "kernel/base/stopwatch.h"
#include "kernel/geometry/nearest_mark.h"
#include "kernel/operators/laplacian.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Returns T with all entries 0: every column of a group has the group's nodes as rows, ascending.
/// `index`: #N, of the node in its group; `size`: #N, of the group, at its smallest node.
SparseMatrix empty_matrix(const std::vector<int>& group, const std::vector<int>& index,
                          const std::vector<int>& size) {
  const auto nodes = static_cast<int>(group.size());
  SparseMatrix T(nodes, nodes);
  int* begin = T.outerIndexPtr();
  for (int n = 0; n < nodes; ++n) begin[n + 1] = begin[n] + size[group[n]];
  T.resizeNonZeros(begin[nodes]);
  // Each node writes itself into the first column of its group; the other columns are copies.
  for (int n = 0; n < nodes; ++n) T.innerIndexPtr()[begin[group[n]] + index[n]] = n;
  for (int n = 0; n < nodes; ++n)
    for (int i = 0; i < size[group[n]]; ++i)
      T.innerIndexPtr()[begin[n] + i] = T.innerIndexPtr()[begin[group[n]] + i];
  T.coeffs().setZero();
  return T;
}

SparseMatrix gap_matrix(const DepthForest& forest) {
  const size_t nodes = forest.group.size();
  std::vector<int> index;
  std::vector<int> size(nodes, 0);
  index.reserve(nodes);
  for (const int smallest : forest.group) index.push_back(size[smallest]++);
  std::vector<int> parent(nodes, -1);
  std::vector<double> sign(nodes, 1);
  for (const DepthGap& gap : forest.gaps) {
    parent[gap.child] = gap.parent;
    sign[gap.child] = gap.sign;
  }
  SparseMatrix T = empty_matrix(forest.group, index, size);
  for (size_t n = 0; n < nodes; ++n)
    for (int on_way = static_cast<int>(n); on_way >= 0; on_way = parent[on_way])
      T.valuePtr()[T.outerIndexPtr()[on_way] + index[n]] = sign[on_way];
  return T;
}

int count(const std::vector<uint8_t>& flags) {
  return static_cast<int>(std::count(flags.begin(), flags.end(), 1));
}

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

VectorXd root_heights(const DepthForest& forest, const VectorXd& f) {
  VectorXd heights = f;
  for (const DepthGap& gap : forest.gaps) heights[gap.child] = 0;
  return heights;
}

VectorXd beyond_roots(const DepthSystem& system, const VectorXd& f) {
  return f - system.T * root_heights(system.forest, f);
}

std::vector<uint8_t> closed_gaps(const DepthForest& forest, const std::vector<double>& h) {
  std::vector<uint8_t> closed(forest.group.size(), 0);
  for (const DepthGap& gap : forest.gaps)
    closed[gap.child] = gap.sign * (h[gap.child] - h[gap.parent]) <= 0;
  return closed;
}

std::vector<double> heights_of(const DepthSystem& system, const VectorXd& roots, const VectorXd& z,
                               double scale) {
  const double unit = 1 / scale;
  std::vector<double> height(roots.begin(), roots.end());
  for (int n = 0; n < roots.size(); ++n)
    if (system.is_root(n)) height[n] += z[n] / scale;
  for (const DepthGap& gap : system.forest.gaps)
    height[gap.child] = height[gap.parent] + gap.sign * (z[gap.child] * unit);
  return height;
}

void set_forest(DepthForest forest, const ShiftMetric& metric, DepthSystem& system) {
  system.T = gap_matrix(forest);
  system.qp.K = galerkin_lower(metric.A, system.T);
  system.qp.bounded.assign(forest.group.size(), 0);
  system.qp.fixed.assign(forest.group.size(), 0);
  for (const DepthGap& gap : forest.gaps)
    (gap.equal ? system.qp.fixed : system.qp.bounded)[gap.child] = 1;
  system.forest = std::move(forest);
  system.closed.clear();
}

DepthSystem make_depth_system(DepthForest forest, const ShiftMetric& metric,
                              const std::vector<int>& elimination, SparseCholesky factor,
                              const RunContext& context) {
  DepthSystem system;
  system.factor = std::move(factor);
  PieceTimer assembling(context, "assemble");
  set_forest(std::move(forest), metric, system);
  assembling.stop();
  if (context.cancelled()) return system;
  const PieceTimer analysing(context, "analyse");
  system.factor.analyse(system.qp.K, Refactorisation::incremental, elimination, context);
  return system;
}

SolveStatus solve_heights(DepthSystem& system, const ShiftMetric& metric, const VectorXd& f,
                          Ordering& ordering, const RunContext& context) {
  if (context.cancelled()) return SolveStatus::interrupted;
  const VectorXd d = metric.scale * beyond_roots(system, f);
  const VectorXd force = metric.A * d + metric.b;
  system.qp.b = system.T.transpose() * force;
  BoundQpOptions options;
  options.start_active = system.closed;
  BoundQpSolution solution = solve_bound_qp(system.qp, system.factor, std::move(options), context);
  ordering.h = heights_of(system, root_heights(system.forest, f), solution.z, metric.scale);
  ordering.equalities = count(system.qp.fixed);
  ordering.inequalities = count(system.qp.bounded);
  ordering.report = solution.report;
  ordering.report.energy += 0.5 * (d.dot(force) + metric.rest(-d));
  system.closed = std::move(solution.active);
  return solution.report.status;
}

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
