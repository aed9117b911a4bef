#include "kernel/cholesky/eliminate_front.h"

#include <algorithm>
#include <cstdint>

#include "kernel/base/workers.h"

namespace relievo {
namespace {

/// Columns that are eliminated before the others are updated.
constexpr int block_columns = 64;
/// Rows or columns of one task.
constexpr int piece_size = 32;
/// Multiplications below which tasks do not pay.
constexpr int64_t least_work = 400000;

int pieces_of(Range range) {
  return std::max(0, range.end - range.begin + piece_size - 1) / piece_size;
}

Range piece_of(Range range, int p) {
  const int begin = range.begin + p * piece_size;
  return {begin, std::min(begin + piece_size, range.end)};
}

/// Eliminates the rows below those of the block's own columns, in tasks.
void eliminate_below(const FrontalKernels& kernels, const Front& front, Range block, Range rows) {
  run_tasks(pieces_of(rows),
            [&](int p) { kernels.eliminate_rows(front, block, piece_of(rows, p)); });
}

/// Eliminates the columns of the block on all rows. Returns false where a pivot is not positive.
bool eliminate_block(const FrontalKernels& kernels, const Front& front, Range block) {
  const int64_t columns = block.end - block.begin;
  const Range own{block.begin, padded(block.end)};
  const Range below{own.end, padded(front.rows)};
  if (columns * columns * (below.end - below.begin) < 2 * least_work)
    return kernels.eliminate_rows(front, block, {own.begin, below.end});
  if (!kernels.eliminate_rows(front, block, own)) return false;
  eliminate_below(kernels, front, block, below);
  return true;
}

/// Subtracts the contribution of the block from all columns behind it.
void update_rest(const FrontalKernels& kernels, const Front& front, Range block) {
  const Range panel{block.end, front.columns};
  const Range update{front.columns, front.rows};
  const int64_t below = front.rows - block.end;
  if ((block.end - block.begin) * below * below < 2 * least_work) {
    kernels.update_columns(front, block, panel);
    kernels.update_columns(front, block, update);
    return;
  }
  const int in_panel = pieces_of(panel);
  run_tasks(in_panel + pieces_of(update), [&](int p) {
    kernels.update_columns(front, block,
                           p < in_panel ? piece_of(panel, p) : piece_of(update, p - in_panel));
  });
}

}  // namespace

bool eliminate_front(const FrontalKernels& kernels, const Front& front,
                     const std::atomic<bool>* stop) {
  for (int begin = 0; begin < front.columns; begin += block_columns) {
    const Range block{begin, std::min(begin + block_columns, front.columns)};
    if (!eliminate_block(kernels, front, block)) return false;
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) return false;
    update_rest(kernels, front, block);
  }
  return true;
}

}  // namespace relievo
