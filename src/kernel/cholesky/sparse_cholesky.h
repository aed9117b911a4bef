#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/symmetric_graph.h"
#include "relievo/run_context.h"

namespace relievo {

/// How much of the factor refactorise() computes again: all of it, or only the fronts that depend
/// on changed entries. The latter keeps all updates, which takes about three times the memory of
/// the factor in addition.
enum class Refactorisation { complete, incremental };

/// Cholesky factorisation P A P' = L L' of symmetric positive definite sparse matrices by the
/// multifrontal method [Duff and Reid 1983; Liu 1992]. A pattern is analysed once, and values are
/// factorised as often as needed. Matrices must be compressed; only their lower triangle (row >=
/// column) is read, and explicit zeros belong to the pattern. The same input gives the same bits on
/// every processor and with any number of threads. docs/cholesky.md describes the method.
class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Analyses the pattern of A and lays out the factor, in the memory of the last one where it
  /// fits. Rows are eliminated in the given `order`, a permutation; where it is empty, in an
  /// approximate minimum degree order. Returns false where `context` is cancelled; then nothing is
  /// analysed. Near-linear in the entries of A and the row indices of the fronts.
  bool analyse(const SparseMatrix& A, Refactorisation refactorisation = Refactorisation::complete,
               std::span<const int> order = {}, const RunContext& context = {});

  /// Returns the number of entries of L, stored zeros included. O(n).
  Eigen::Index factor_entries() const;

  /// Factorises A, which has the analysed pattern. Rows and columns i with fixed[i] != 0 (empty, or
  /// #rows flags) are replaced by those of the identity. Returns false where A is not positive
  /// definite, or `context` is cancelled. Uses all workers. O(sum of columns * rows^2 of the
  /// fronts).
  bool factorise(const SparseMatrix& A, std::span<const uint8_t> fixed = {},
                 const RunContext& context = {});

  /// Factorises A with the same result, to the last bit, as factorise(). After an incremental
  /// analysis it computes only the fronts that depend on entries which differ from the last
  /// factorisation. O(entries of A + arithmetic of these fronts).
  bool refactorise(const SparseMatrix& A, std::span<const uint8_t> fixed = {},
                   const RunContext& context = {});

  /// Returns the graph of the analysed pattern after an incremental analysis, else an empty one.
  const SymmetricGraph& graph() const;

  /// Solves A x = b with the last factorised A; b has #rows entries. Precondition: the last
  /// factorisation returned true. O(entries of L), fewer where b is local.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  /// Computes the Schur complement of the last factorised A on `rows`: the symmetric matrix, as
  /// large as there are `rows`, that is left once all others are eliminated. Preconditions: the
  /// last factorisation returned true, and `rows` were the last in the order of the analysis. O(n +
  /// #rows^3).
  Eigen::MatrixXd schur_complement(std::span<const int> rows) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Extracts the lower triangle of a block of A, `size` x `size`: row and column n of A become those
/// with number place[n], or are left out where it is -1. Precondition: `place` ascends apart from
/// -1. O(entries).
SparseMatrix lower_block(const SparseMatrix& A, const std::vector<int>& place, int size);

/// Restricts an order of the rows of A to such a block: returns place[n] for each n of the order
/// where it is not -1. O(n).
std::vector<int> order_of_places(const std::vector<int>& order, const std::vector<int>& place);

}  // namespace relievo
