#pragma once

#include <cstddef>

namespace relievo {

/// Rows per vector of the kernels. Columns start at multiples of it and are padded to it.
constexpr int pack_rows = 4;

constexpr int padded(int rows) { return (rows + pack_rows - 1) / pack_rows * pack_rows; }

/// Columns that are updated at a time.
constexpr int tile_columns = 4;
static_assert(tile_columns == pack_rows, "each tile has one pack of rows less than the last");

/// A dense symmetric matrix of which the first `columns` columns are eliminated. Only entries on or
/// below the diagonal mean anything; those above it and the padding are finite but arbitrary. The
/// other columns, the update, are stored in tiles side by side; each tile begins at the pack of its
/// first diagonal entry, so that little more than a triangle is stored.
struct Front {
  int rows = 0;
  int columns = 0;
  double* panel = nullptr;   ///< the eliminated columns, stride() apart
  double* update = nullptr;  ///< the tiles of the others

  std::ptrdiff_t stride() const { return padded(rows); }
  /// Of the update, as the functions below: first row that is stored of a column's tile, and what
  /// columns of the tile are apart.
  int top(int c) const { return (c - (c - columns) % tile_columns) / pack_rows * pack_rows; }
  std::ptrdiff_t tile_stride(int c) const { return stride() - top(c); }
  /// Doubles before tile t, whose columns are stored from top() on.
  std::ptrdiff_t tile_begin(int t) const {
    const std::ptrdiff_t tallest = tile_columns * (stride() - columns / pack_rows * pack_rows);
    return t * tallest - tile_columns * tile_columns / 2 * std::ptrdiff_t{t} * (t - 1);
  }
  std::ptrdiff_t update_size() const {
    const int wide = rows - columns;
    const int last = wide / tile_columns;
    return tile_begin(last) + wide % tile_columns * tile_stride(columns + last * tile_columns);
  }
  /// Row r of column c is column(c)[r].
  double* column(int c) const {
    if (c < columns) return panel + c * stride();
    const int in_tile = (c - columns) % tile_columns;
    return update + tile_begin((c - columns) / tile_columns) + in_tile * tile_stride(c) - top(c);
  }
};

/// Rows or columns [begin, end).
struct Range {
  int begin = 0;
  int end = 0;
};

/// Dense arithmetic on fronts. Every entry is computed by the same operations in the same order
/// whatever the instruction set, so that all sets give the same bits.
struct FrontalKernels {
  /// A block of the panel's columns := those of the Cholesky factor on some rows, whole packs. The
  /// rows of the block's own columns come first, with or before the others. False when a pivot is
  /// not positive.
  bool (*eliminate_rows)(const Front& front, Range block, Range rows);
  /// Subtracts what a block contributes to other columns, all of the panel or of the update: these
  /// from the first of a tile on.
  void (*update_columns)(const Front& front, Range block, Range columns);
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
