#pragma once

#include <cstddef>

namespace relievo {

/// Rows of a pack, the unit of the kernels. Columns are padded to a multiple of it.
constexpr int pack_rows = 4;

/// Rounds a number of rows up to whole packs.
constexpr int padded(int rows) { return (rows + pack_rows - 1) / pack_rows * pack_rows; }

/// Columns that are updated at a time.
constexpr int tile_columns = 4;
static_assert(tile_columns == pack_rows, "each tile has one pack of rows less than the last");

/// A dense symmetric matrix whose first `columns` columns, the panel, are eliminated; the other
/// columns are the update. Only entries on or below the diagonal are used; entries above it and the
/// padding are finite but arbitrary. The panel is stored by columns. The update is stored in tiles
/// of columns side by side. Each tile begins at the pack of its first diagonal entry, so that
/// little more than a triangle is stored.
struct Front {
  int rows = 0;
  int columns = 0;
  double* panel = nullptr;   ///< columns, stride() apart
  double* update = nullptr;  ///< tiles of the other columns

  /// Returns the distance between columns of the panel.
  std::ptrdiff_t stride() const { return padded(rows); }
  /// Returns the first row that is stored of the tile of column c of the update.
  int top(int c) const { return (c - (c - columns) % tile_columns) / pack_rows * pack_rows; }
  /// Returns the distance between columns of the tile of column c of the update.
  std::ptrdiff_t tile_stride(int c) const { return stride() - top(c); }
  /// Returns the number of doubles before tile t of the update.
  std::ptrdiff_t tile_begin(int t) const {
    const std::ptrdiff_t tallest = tile_columns * (stride() - columns / pack_rows * pack_rows);
    return t * tallest - tile_columns * tile_columns / 2 * std::ptrdiff_t{t} * (t - 1);
  }
  /// Returns the size of the update in doubles.
  std::ptrdiff_t update_size() const {
    const int wide = rows - columns;
    const int last = wide / tile_columns;
    return tile_begin(last) + wide % tile_columns * tile_stride(columns + last * tile_columns);
  }
  /// Returns column c, of the panel or the update: row r is column(c)[r], for r >= c.
  double* column(int c) const {
    if (c < columns) return panel + c * stride();
    const int in_tile = (c - columns) % tile_columns;
    return update + tile_begin((c - columns) / tile_columns) + in_tile * tile_stride(c) - top(c);
  }
};

/// A range [begin, end) of rows, columns or fronts.
struct Range {
  int begin = 0;
  int end = 0;
};

/// Dense arithmetic on fronts for one instruction set. Every entry is computed by the same
/// operations in the same order with all instruction sets, so that all give the same bits.
struct FrontalKernels {
  /// Replaces the columns `block` of the panel by those of the Cholesky factor on `rows`, whole
  /// packs. The rows of the block's own columns come first, in the same call or an earlier one.
  /// Returns false where a pivot is not positive.
  bool (*eliminate_rows)(const Front& front, Range block, Range rows);
  /// Subtracts the contribution of the columns `block` from other columns: `columns` of the panel,
  /// or of the update from the first one of a tile on.
  void (*update_columns)(const Front& front, Range block, Range columns);
  /// Solves L x = b with the columns of the factor, in place: x, by row of the front and padded
  /// like a column, holds b on the columns and afterwards the solution there; the contribution of
  /// the solution is subtracted from the rows below.
  void (*solve_forward)(const Front& front, double* x);
  /// Solves L' x = b with the columns of the factor, in place: x holds b on the columns and the
  /// solution on the rows below.
  void (*solve_backward)(const Front& front, double* x);
};

/// Returns the kernels for any processor.
const FrontalKernels& portable_kernels();

/// Returns the fastest kernels for this processor.
const FrontalKernels& best_kernels();

}  // namespace relievo
