#include "kernel/cholesky/frontal_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#if defined(__x86_64__) && defined(__GNUC__)
#define RELIEVO_WIDE_KERNELS
#endif

/// Functions called by the wide kernels must be compiled for their instruction set, so they are
/// inlined.
#define RELIEVO_INLINE [[gnu::always_inline]] inline

namespace relievo {
namespace {

using Index = std::ptrdiff_t;
/// Vectors of the instruction sets. Their lanes are separate sums, so the width changes no result.
using Pack2 = double __attribute__((vector_size(16)));
using Pack4 = double __attribute__((vector_size(32)));

template <class Pack>
constexpr int lanes = sizeof(Pack) / sizeof(double);

template <class Pack>
RELIEVO_INLINE void load(const double* from, Pack& pack) {
  std::memcpy(&pack, from, sizeof pack);
}
template <class Pack>
RELIEVO_INLINE void store(const Pack& pack, double* to) {
  std::memcpy(to, &pack, sizeof pack);
}

/// Computes to -= from * factor for the rows [begin, end), multiples of pack_rows.
template <class Pack>
RELIEVO_INLINE void subtract_multiple(double* to, const double* from, double factor, int begin,
                                      int end) {
  for (int row = begin; row < end; row += lanes<Pack>) {
    Pack entry;
    Pack left;
    load(to + row, entry);
    load(from + row, left);
    entry -= left * factor;
    store(entry, to + row);
  }
}

/// The product A B' that is subtracted from a tile. A and B have `depth` columns, `stride` apart.
struct Product {
  const double* A;
  const double* B;
  Index stride;
  int depth;
};

template <class Pack, int Packs, int Columns>
RELIEVO_INLINE void subtract_tile(double* C, Index c_stride, const Product& product) {
  Pack sum[Columns][Packs] = {};
  const double* A = product.A;
  const double* B = product.B;
  for (int p = 0; p < product.depth; ++p, A += product.stride, B += product.stride) {
    Pack a[Packs];
    for (int r = 0; r < Packs; ++r) load(A + r * lanes<Pack>, a[r]);
    for (int c = 0; c < Columns; ++c)
      for (int r = 0; r < Packs; ++r) sum[c][r] += a[r] * B[c];
  }
  for (int c = 0; c < Columns; ++c)
    for (int r = 0; r < Packs; ++r) {
      double* to = C + c * c_stride + r * lanes<Pack>;
      Pack entry;
      load(to, entry);
      entry -= sum[c][r];
      store(entry, to);
    }
}

/// Subtracts a product from the rows [row, end) of `Columns` columns, both multiples of a pack.
template <class Pack, int Packs, int Columns>
RELIEVO_INLINE void subtract_strip(double* C, Index c_stride, Product product, int row, int end) {
  const double* A = product.A;
  for (; row + Packs * lanes<Pack> <= end; row += Packs * lanes<Pack>) {
    product.A = A + row;
    subtract_tile<Pack, Packs, Columns>(C + row, c_stride, product);
  }
  for (; row < end; row += lanes<Pack>) {
    product.A = A + row;
    subtract_tile<Pack, 1, Columns>(C + row, c_stride, product);
  }
}

/// Subtracts the contribution of the panel's columns `from` from `count` <= tile_columns columns on
/// some rows.
template <class Pack, int Packs>
RELIEVO_INLINE void subtract_columns(const Front& front, int column, int count, Range from,
                                     Range rows) {
  if (from.begin == from.end) return;
  const double* A = front.panel + from.begin * front.stride();
  const Product product{A, A + column, front.stride(), from.end - from.begin};
  double* C = front.column(column);
  const Index c_stride = column < front.columns ? front.stride() : front.tile_stride(column);
  const int row = std::max(rows.begin, column / pack_rows * pack_rows);
  switch (count) {
    case 1:
      return subtract_strip<Pack, Packs, 1>(C, c_stride, product, row, rows.end);
    case 2:
      return subtract_strip<Pack, Packs, 2>(C, c_stride, product, row, rows.end);
    case 3:
      return subtract_strip<Pack, Packs, 3>(C, c_stride, product, row, rows.end);
    default:
      return subtract_strip<Pack, Packs, 4>(C, c_stride, product, row, rows.end);
  }
}

/// Replaces a pivot by its square root. Returns false where it is not positive and finite.
RELIEVO_INLINE bool take_root(double& pivot) {
  if (!(pivot > 0 && pivot < HUGE_VAL)) return false;
  pivot = std::sqrt(pivot);
  return true;
}

/// Eliminates some rows of a panel column from which the contribution of the columns before `first`
/// was subtracted. Returns false where the pivot is among the rows and not positive.
template <class Pack>
RELIEVO_INLINE bool eliminate_column(const Front& front, int first, int column, Range rows) {
  double* x = front.panel + column * front.stride();
  const int begin = std::max(rows.begin, column / pack_rows * pack_rows);
  const int end = rows.end;
  for (int c = first; c < column; ++c) {
    const double* other = front.panel + c * front.stride();
    subtract_multiple<Pack>(x, other, other[column], begin, end);
  }
  const bool has_pivot = begin <= column;
  if (has_pivot && !take_root(x[column])) return false;
  const double root = x[column];
  const double reciprocal = 1 / root;
  for (int row = begin; row < end; row += lanes<Pack>) {
    Pack entry;
    load(x + row, entry);
    entry *= reciprocal;
    store(entry, x + row);
  }
  if (!has_pivot) return true;
  x[column] = root;
  std::fill(x + begin, x + column, 0.0);
  return true;
}

template <class Pack, int Packs>
RELIEVO_INLINE bool eliminate_rows(const Front& front, Range block, Range rows) {
  for (int j = block.begin; j < block.end; j += tile_columns) {
    const int count = std::min(tile_columns, block.end - j);
    subtract_columns<Pack, Packs>(front, j, count, {block.begin, j}, rows);
    for (int c = j; c < j + count; ++c)
      if (!eliminate_column<Pack>(front, j, c, rows)) return false;
  }
  return true;
}

template <class Pack, int Packs>
RELIEVO_INLINE void update_columns(const Front& front, Range block, Range columns) {
  const Range rows{0, padded(front.rows)};
  for (int j = columns.begin; j < columns.end; j += tile_columns)
    subtract_columns<Pack, Packs>(front, j, std::min(tile_columns, columns.end - j), block, rows);
}

/// The columns [block, block + count) of the panel; `block` is a multiple of a pack.
struct ColumnBlock {
  const double* L;  ///< first column
  Index stride;
  int block;
  int count;
};

/// Solves with the triangle of a block.
RELIEVO_INLINE void solve_block_forward(const ColumnBlock& columns, double* x) {
  const double* L = columns.L;
  for (int c = columns.block; c < columns.block + columns.count; ++c, L += columns.stride) {
    const double value = x[c] / L[c];
    for (int row = c + 1; row < columns.block + pack_rows; ++row) x[row] -= L[row] * value;
    x[c] = value;
  }
}

/// Computes x -= L value for the rows [begin, end), where value is x on the columns of the block.
template <class Pack, int Columns>
RELIEVO_INLINE void subtract_block(const ColumnBlock& columns, double* x, int begin, int end) {
  double value[Columns];
  std::memcpy(value, x + columns.block, sizeof value);
  for (int row = begin; row < end; row += lanes<Pack>) {
    Pack entry;
    load(x + row, entry);
    for (int k = 0; k < Columns; ++k) {
      Pack left;
      load(columns.L + k * columns.stride + row, left);
      entry -= left * value[k];
    }
    store(entry, x + row);
  }
}

template <class Pack>
RELIEVO_INLINE void solve_forward(const Front& front, double* x) {
  const int end = padded(front.rows);
  for (int block = 0; block < front.columns; block += pack_rows) {
    const int count = std::min(pack_rows, front.columns - block);
    const ColumnBlock columns{front.panel + block * front.stride(), front.stride(), block, count};
    solve_block_forward(columns, x);
    const int below = block + pack_rows;
    switch (count) {
      case 1:
        subtract_block<Pack, 1>(columns, x, below, end);
        break;
      case 2:
        subtract_block<Pack, 2>(columns, x, below, end);
        break;
      case 3:
        subtract_block<Pack, 3>(columns, x, below, end);
        break;
      default:
        subtract_block<Pack, pack_rows>(columns, x, below, end);
    }
  }
}

/// Distance in doubles by which backward solves prefetch. They read the panels from their end,
/// which processors do not predict.
constexpr Index prefetch_distance = 1024;

/// Computes the sums of L x over the rows [begin, end) for `Columns` columns, whose chains of
/// additions run side by side.
template <class Pack, int Columns>
RELIEVO_INLINE void sum_products(const ColumnBlock& columns, const double* x, int begin, int end,
                                 double* sums) {
  constexpr int parts = pack_rows / lanes<Pack>;
  Pack sum[Columns][parts] = {};
  const double* before = columns.L - prefetch_distance;
  for (int row = begin; row < end; row += pack_rows) {
    for (int k = 0; k < Columns; ++k) __builtin_prefetch(before + k * columns.stride + row);
    for (int r = 0; r < parts; ++r) {
      Pack right;
      load(x + row + r * lanes<Pack>, right);
      for (int k = 0; k < Columns; ++k) {
        Pack left;
        load(columns.L + k * columns.stride + row + r * lanes<Pack>, left);
        sum[k][r] += left * right;
      }
    }
  }
  for (int k = 0; k < Columns; ++k) {
    double part[pack_rows];
    std::memcpy(part, sum[k], sizeof part);
    sums[k] = (part[0] + part[1]) + (part[2] + part[3]);
  }
}

template <class Pack>
RELIEVO_INLINE void solve_backward(const Front& front, double* x) {
  const int end = padded(front.rows);
  for (int block = (front.columns - 1) / pack_rows * pack_rows; block >= 0; block -= pack_rows) {
    const int count = std::min(pack_rows, front.columns - block);
    const ColumnBlock columns{front.panel + block * front.stride(), front.stride(), block, count};
    const int below = block + pack_rows;
    double sums[pack_rows];
    switch (count) {
      case 1:
        sum_products<Pack, 1>(columns, x, below, end, sums);
        break;
      case 2:
        sum_products<Pack, 2>(columns, x, below, end, sums);
        break;
      case 3:
        sum_products<Pack, 3>(columns, x, below, end, sums);
        break;
      default:
        sum_products<Pack, pack_rows>(columns, x, below, end, sums);
    }
    for (int k = count - 1; k >= 0; --k) {
      const double* L = columns.L + k * columns.stride;
      double sum = sums[k];
      for (int row = block + k + 1; row < std::min(block + pack_rows, front.rows); ++row)
        sum += L[row] * x[row];
      x[block + k] = (x[block + k] - sum) / L[block + k];
    }
  }
}

bool eliminate_portable(const Front& front, Range block, Range rows) {
  return eliminate_rows<Pack2, 2>(front, block, rows);
}
void update_portable(const Front& front, Range block, Range columns) {
  update_columns<Pack2, 2>(front, block, columns);
}
void forward_portable(const Front& front, double* x) { solve_forward<Pack2>(front, x); }
void backward_portable(const Front& front, double* x) { solve_backward<Pack2>(front, x); }

#ifdef RELIEVO_WIDE_KERNELS
#define RELIEVO_WIDE [[gnu::target("avx2")]]
RELIEVO_WIDE bool eliminate_wide(const Front& front, Range block, Range rows) {
  return eliminate_rows<Pack4, 2>(front, block, rows);
}
RELIEVO_WIDE void update_wide(const Front& front, Range block, Range columns) {
  update_columns<Pack4, 2>(front, block, columns);
}
RELIEVO_WIDE void forward_wide(const Front& front, double* x) { solve_forward<Pack4>(front, x); }
RELIEVO_WIDE void backward_wide(const Front& front, double* x) { solve_backward<Pack4>(front, x); }
#endif

constexpr FrontalKernels portable = {eliminate_portable, update_portable, forward_portable,
                                     backward_portable};

}  // namespace

const FrontalKernels& portable_kernels() { return portable; }

const FrontalKernels& best_kernels() {
#ifdef RELIEVO_WIDE_KERNELS
  static constexpr FrontalKernels wide = {eliminate_wide, update_wide, forward_wide, backward_wide};
  static const bool has_wide = __builtin_cpu_supports("avx2") != 0;
  if (has_wide) return wide;
#endif
  return portable;
}

}  // namespace relievo
