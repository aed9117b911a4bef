#include "benchmarks/references/lagrange_active_set.h"

#include <Eigen/SparseLU>
#include <cstdint>

namespace relievo::benchmarks {
namespace {

using Eigen::VectorXd;

constexpr int max_iterations = 60;
constexpr double tolerance = 1e-10;

/// [A C'; C 0] with a row h[lower] - h[upper] for every active pair.
SparseMatrix kkt_matrix(const SparseMatrix& A, const std::vector<relief::DepthPair>& active) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
      entries.emplace_back(entry.row(), j, entry.value());
  const int nodes = static_cast<int>(A.rows());
  for (size_t i = 0; i < active.size(); ++i) {
    const int row = nodes + static_cast<int>(i);
    for (const auto& [node, sign] : {std::pair(active[i].lower, 1.0), {active[i].upper, -1.0}}) {
      entries.emplace_back(row, node, sign);
      entries.emplace_back(node, row, sign);
    }
  }
  const int size = nodes + static_cast<int>(active.size());
  SparseMatrix K(size, size);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

/// Flips the pairs that are on the wrong side. Returns false where there are none.
bool flip_wrong(const std::vector<relief::DepthPair>& pairs, const VectorXd& solution,
                Eigen::Index nodes, std::vector<uint8_t>& active) {
  bool changed = false;
  Eigen::Index multiplier = nodes;
  for (size_t i = 0; i < pairs.size(); ++i) {
    const bool was_active = active[i] != 0;
    const double value =
        was_active ? -solution[multiplier++] : solution[pairs[i].lower] - solution[pairs[i].upper];
    if (pairs[i].equal || value <= tolerance) continue;
    active[i] = !was_active;
    changed = true;
  }
  return changed;
}

}  // namespace

ReferenceSolution solve_with_multipliers(const SparseMatrix& A, const VectorXd& f,
                                         const std::vector<relief::DepthPair>& pairs) {
  ReferenceSolution result;
  std::vector<uint8_t> active;
  for (const relief::DepthPair& pair : pairs) active.push_back(pair.equal);
  const VectorXd b = A * f;
  while (result.iterations++ < max_iterations) {
    std::vector<relief::DepthPair> rows;
    for (size_t i = 0; i < pairs.size(); ++i)
      if (active[i] != 0) rows.push_back(pairs[i]);
    const SparseMatrix K = kkt_matrix(A, rows);
    VectorXd right = VectorXd::Zero(K.rows());
    right.head(b.size()) = b;
    const Eigen::SparseLU<SparseMatrix> factor(K);
    if (factor.info() != Eigen::Success) return result;
    const VectorXd solution = factor.solve(right);
    result.x = solution.head(b.size());
    result.solved = !flip_wrong(pairs, solution, b.size(), active);
    if (result.solved) return result;
  }
  return result;
}

}  // namespace relievo::benchmarks
