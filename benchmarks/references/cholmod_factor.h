#pragma once

#include <memory>

#include "kernel/base/sparse_matrix.h"

namespace relievo::benchmarks {

/// Factorises by CHOLMOD, in the order of its approximate minimum degree. CHOLMOD chooses between
/// its simplicial and its supernodal method.
class CholmodFactor {
 public:
  /// Analyses the pattern of a matrix of which the lower triangle is stored.
  explicit CholmodFactor(const SparseMatrix& lower);
  ~CholmodFactor();
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  /// Factorises the values of the matrix; false where it is not positive definite.
  bool factorise();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace relievo::benchmarks
