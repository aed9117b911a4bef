#pragma once

#include <atomic>
#include <cstddef>

namespace relievo {

/// Rows per vector of the kernels. Columns start at multiples of it and are padded to it.
constexpr int pack_rows = 4;

constexpr int padded(int rows) { return (rows + pack_rows - 1) / pack_rows * pack_rows; }

/// A dense symmetric matrix of which the first `columns` columns are eliminated. Only entries on or
/// below the diagonal mean anything; those above it and the padding are finite but arbitrary.
struct Front {
  int rows = 0;
  int columns = 0;
  double* panel = nullptr;   ///< the eliminated columns, stride() apart
  double* update = nullptr;  ///< the other columns, update_stride() apart, without rows < top()

  std::ptrdiff_t stride() const { return padded(rows); }
  int top() const { return columns / pack_rows * pack_rows; }
  std::ptrdiff_t update_stride() const { return padded(rows) - top(); }
  std::size_t update_size() const {
    return static_cast<std::size_t>(update_stride()) * static_cast<std::size_t>(rows - columns);
  }
  /// Row r of column c is column(c)[r].
  double* column(int c) const {
    return c < columns ? panel + c * stride() : update + (c - columns) * update_stride() - top();
  }
};

/// Dense arithmetic on fronts. Every entry is computed by the same operations in the same order
/// whatever the instruction set, so that all sets give the same bits.
struct FrontalKernels {
  /// panel := its columns of the Cholesky factor, update -= what they contribute to the rest.
  /// False when a pivot is not positive, or as soon as `stop`, which may be null, is set.
  bool (*eliminate)(const Front& front, const std::atomic<bool>* stop);
  /// Solves with the factor's columns: x (the front's rows) := L^-1 x on the columns, and what they
  /// contribute is subtracted from the rows below. x is padded like a column.
  void (*solve_forward)(const Front& front, double* x);
  /// Solves with the transposed columns, the rows below being known.
  void (*solve_backward)(const Front& front, double* x);
};

/// For any processor.
const FrontalKernels& portable_kernels();

/// The fastest for this processor.
const FrontalKernels& best_kernels();

}  // namespace relievo
