#include "relief/inflation/poisson_system.h"

#include <algorithm>
#include <utility>

#include "kernel/base/piece_timer.h"
#include "relief/inflation/poisson_terms.h"

namespace relievo {

using Eigen::Index;
using Eigen::VectorXd;

PoissonSystem::PoissonSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                             Refactorisation refactorisation, const RunContext& context)
    : unknown_(mesh.node_role.size(), -1) {
  for (size_t n = 0; n < unknown_.size(); ++n) {
    const bool takes_part = discretisation.mass[static_cast<Index>(n)] > 0;
    if (mesh.node_role[n] == NodeRole::outline || !takes_part) continue;
    unknown_[n] = static_cast<int>(node_.size());
    node_.push_back(static_cast<int>(n));
  }
  L_ = lower_block(discretisation.L, unknown_, static_cast<int>(node_.size()));
  collect_links(mesh);
  A_ = L_;
  const PieceTimer analysing(context, "analyse");
  factor_.analyse(L_, refactorisation, order_of_places(discretisation.elimination, unknown_),
                  context);
}

void PoissonSystem::collect_links(const LayeredMesh& mesh) {
  SparseMatrix pattern(L_.rows(), L_.cols());
  std::vector<Eigen::Triplet<double>> entries;
  for (size_t i = 0; i < mesh.ramp_nodes.size(); ++i) {
    const RampNode& ramp = mesh.ramp_nodes[i];
    if (ramp.below < 0 || unknown_[ramp.below] < 0 || unknown_[ramp.node] < 0) continue;
    const auto [column, row] = std::minmax(unknown_[ramp.below], unknown_[ramp.node]);
    links_.push_back({static_cast<int>(i), row, column});
    entries.emplace_back(row, column, 0.0);
  }
  pattern.setFromTriplets(entries.begin(), entries.end());
  if (!links_.empty()) L_ = SparseMatrix(L_ + pattern);
}

void PoissonSystem::set_values(const PoissonBoundary& boundary) {
  A_ = L_;
  for (size_t i = 0; i < node_.size(); ++i)
    A_.valuePtr()[A_.outerIndexPtr()[i]] += boundary.spring[node_[i]];
  for (const Link& link : links_) {
    const double stiffness = boundary.link[link.ramp_node];
    A_.coeffRef(link.row, link.row) += stiffness;
    A_.coeffRef(link.column, link.column) += stiffness;
    A_.coeffRef(link.row, link.column) -= stiffness;
  }
}

std::optional<VectorXd> PoissonSystem::solve(const PoissonBoundary& boundary, const VectorXd& load,
                                             const RunContext& context) {
  if (context.cancelled()) return std::nullopt;
  const auto unknowns = static_cast<Index>(node_.size());
  VectorXd b(unknowns);
  std::vector<uint8_t> held(node_.size());
  for (Index i = 0; i < unknowns; ++i) {
    held[i] = boundary.fixed[node_[i]];
    b[i] = held[i] != 0 ? 0 : load[node_[i]];
  }
  if (!last_ || !(*last_ == boundary)) {
    last_.reset();
    set_values(boundary);
    if (!factor_.refactorise(A_, held, context)) return std::nullopt;
    last_ = boundary;
  }
  const VectorXd x = factor_.solve(b, sweep_);
  if (!x.allFinite()) return std::nullopt;
  VectorXd u = VectorXd::Zero(load.size());
  for (Index i = 0; i < unknowns; ++i) u[node_[i]] = x[i];
  return u;
}

}  // namespace relievo
