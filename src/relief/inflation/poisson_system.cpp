#include "relief/inflation/poisson_system.h"

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
    if (mesh.node_role[n] == NodeRole::outline) continue;
    unknown_[n] = static_cast<int>(node_.size());
    node_.push_back(static_cast<int>(n));
  }
  L_ = lower_block(discretisation.L, unknown_, static_cast<int>(node_.size()));
  A_ = L_;
  const PieceTimer analysing(context, "analyse");
  factor_.analyse(L_, refactorisation, order_of_places(discretisation.elimination, unknown_),
                  context);
}

std::optional<VectorXd> PoissonSystem::solve(const std::vector<uint8_t>& fixed,
                                             const VectorXd& spring, const VectorXd& load,
                                             const RunContext& context) {
  if (context.cancelled()) return std::nullopt;
  const auto unknowns = static_cast<Index>(node_.size());
  VectorXd b(unknowns);
  std::vector<uint8_t> held(node_.size());
  bool same_springs = !held_.empty();
  for (Index i = 0; i < unknowns; ++i) {
    const int n = node_[i];
    held[i] = fixed[n];
    b[i] = held[i] != 0 ? 0 : load[n];
    const int diagonal = A_.outerIndexPtr()[i];  // first of the lower triangle's column
    const double value = L_.valuePtr()[diagonal] + spring[n];
    same_springs = same_springs && A_.valuePtr()[diagonal] == value;
    A_.valuePtr()[diagonal] = value;
  }
  if (!same_springs || held != held_) {
    held_.clear();
    if (!factor_.refactorise(A_, held, context)) return std::nullopt;
    held_ = std::move(held);
  }
  const VectorXd x = factor_.solve(b, sweep_);
  if (!x.allFinite()) return std::nullopt;
  VectorXd u = VectorXd::Zero(load.size());
  for (Index i = 0; i < unknowns; ++i) u[node_[i]] = x[i];
  return u;
}

}  // namespace relievo
