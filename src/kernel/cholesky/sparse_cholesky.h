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

/// Whether refactorise() computes everything again, or no more than needed: this takes some three
/// times the memory of the factor in addition.
enum class Refactorisation { complete, incremental };

/// What the tasks of a factor made of a right-hand side, in the order of elimination.
struct ForwardSweep {
  std::vector<uint64_t> version;  ///< of each task when it was solved
  Eigen::VectorXd b;
  Eigen::VectorXd y;      ///< L^-1 b on the columns of the tasks
  Eigen::MatrixXd above;  ///< what each task contributes to the columns above, one column each
};

/// Cholesky factorisation of symmetric positive definite sparse matrices: the pattern is analysed
/// once, values are factorised as often as needed, by the multifrontal method [Duff and Reid 1983;
/// Liu 1992]. Only the lower triangle (row >= column) of the matrices, which must be
/// compressed, is read; explicit zeros belong to the pattern. The same input gives the same bits on
/// every processor and with any number of threads.
class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Lays out the factor for the pattern of A, where there is room in the memory of the last one.
  /// `order` says in which order to eliminate the rows (all of them, each once); where it is empty,
  /// one that fills in little is chosen. Near-linear in the entries of A and the row indices of the
  /// fronts. False where `context` is cancelled: then nothing is analysed.
  bool analyse(const SparseMatrix& A, Refactorisation refactorisation = Refactorisation::complete,
               std::span<const int> order = {}, const RunContext& context = {});

  /// Entries of the lower triangle of the factor, stored zeros included.
  Eigen::Index factor_entries() const;

  /// Factorises values on the analysed pattern; false when A is not positive definite, or when
  /// `context` is cancelled. Rows and columns i with fixed[i] != 0 (none, or #rows flags) are
  /// replaced by those of the identity. Uses all workers.
  bool factorise(const SparseMatrix& A, std::span<const uint8_t> fixed = {},
                 const RunContext& context = {});

  /// Does what factorise() does, with the same bits; after an incremental analysis, computes only
  /// what depends on entries that are not as in the last factorisation.
  bool refactorise(const SparseMatrix& A, std::span<const uint8_t> fixed = {},
                   const RunContext& context = {});

  /// The same where only `fixed`, #rows flags, differs from the last factorisation. Looks at the
  /// entries of rows that change, and at no others. Precondition: the rest of A is as it was, with
  /// the whole diagonal.
  bool refactorise_fixed(const SparseMatrix& A, std::span<const uint8_t> fixed,
                         const RunContext& context = {});

  /// The entries of the analysed pattern; nothing but after an incremental analysis.
  const SymmetricGraph& graph() const;

  /// Solves A x = b with the last factorised A, b having #rows entries.
  /// Precondition: the last factorisation returned true.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  /// The same with the same bits, where `last` is empty or was left by such a solve with this
  /// factor: where neither b nor A have changed, half of it is not repeated.
  Eigen::VectorXd solve(const Eigen::VectorXd& b, ForwardSweep& last) const;

  /// What is left of the last factorised A on `rows` once all others are eliminated: #rows x #rows,
  /// symmetric. Preconditions: the last factorisation returned true, and `rows` were the last in
  /// the order of the analysis. At most cubic in #rows.
  Eigen::MatrixXd schur_complement(std::span<const int> rows) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The lower triangle of the rows and columns n of A with place[n] >= 0, moved there. `place` rises
/// along the nodes and has `size` entries that are not negative. O(entries).
SparseMatrix lower_block(const SparseMatrix& A, const std::vector<int>& place, int size);

/// The places that are not negative, in an order of the nodes. O(N).
std::vector<int> order_of_places(const std::vector<int>& order, const std::vector<int>& place);

}  // namespace relievo
