#pragma once

#include <memory>

#include "kernel/base/sparse_matrix.h"

namespace relievo::benchmarks {

/// Factorises by CHOLMOD, in the order of its approximate minimum degree.
class CholmodFactor {
 public:
  /// Analyses the pattern of a matrix of which the lower triangle is stored. Takes the simplicial
  /// method, or lets CHOLMOD choose between that and its supernodal one.
  CholmodFactor(const SparseMatrix& lower, bool simplicial);
  ~CholmodFactor();
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  /// Factorises the values of the matrix. Returns false where it is not positive definite.
  bool factorise();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace relievo::benchmarks
