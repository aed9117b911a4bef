#include "kernel/cholesky/front_numerics.h"

#include <algorithm>
#include <cstdint>

#include "kernel/base/workers.h"

namespace relievo {
namespace {

/// Columns that are eliminated before the rest is updated.
constexpr int block_columns = 64;
/// Rows or columns that are one task.
constexpr int piece_size = 32;
/// Multiplications that are worth tasks.
constexpr int64_t least_work = 400000;

int pieces_of(Range range) {
  return std::max(0, range.end - range.begin + piece_size - 1) / piece_size;
}

Range piece_of(Range range, int p) {
  const int begin = range.begin + p * piece_size;
  return {begin, std::min(begin + piece_size, range.end)};
}

/// Eliminates the rows below those of the block's own columns.
void eliminate_below(const FrontalKernels& kernels, const Front& front, Range block, Range rows) {
  run_tasks(pieces_of(rows),
            [&](int p) { kernels.eliminate_rows(front, block, piece_of(rows, p)); });
}

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

/// Subtracts what the block contributes to the columns behind it.
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

using Eigen::VectorXd;

/// Solves with one front after the other. x holds the rows of a front.
class ForwardSolve {
 public:
  ForwardSolve(const FactorMemory& factor, VectorXd& y)
      : factor_(factor), y_(y), x_(padded(factor.layout.most_rows)) {
    x_.setZero();
  }

  /// A front in a task that ends before column `end`: what belongs to columns from there on is
  /// added to `above`.
  void solve_below(int s, int end, double* above) {
    if (is_zero(s)) return;
    const Front source = gather(s);
    const int* row = factor_.rows(s);
    int i = source.columns;
    for (; i < source.rows && row[i] < end; ++i) y_[row[i]] += x_[i];
    const std::vector<int>& place = factor_.layout.tasks.top_place;
    for (; i < source.rows; ++i) above[place[row[i]]] += x_[i];
  }

  void solve_top(int s) {
    if (is_zero(s)) return;
    const Front source = gather(s);
    const int* row = factor_.rows(s);
    for (int i = source.columns; i < source.rows; ++i) y_[row[i]] += x_[i];
  }

 private:
  /// Whether nothing has come to the front's columns, as where the right-hand side is local.
  bool is_zero(int s) const {
    const std::vector<int>& begin = factor_.layout.fronts.column_begin;
    return (y_.segment(begin[s], begin[s + 1] - begin[s]).array() == 0).all();
  }

  /// Solves the columns; leaves what they contribute to the rows below in x.
  Front gather(int s) {
    const Front source = factor_.front(s);
    const int* row = factor_.rows(s);
    for (int i = 0; i < source.columns; ++i) x_[i] = y_[row[i]];
    for (int i = source.columns; i < source.rows; ++i) x_[i] = 0;
    best_kernels().solve_forward(source, x_.data());
    for (int i = 0; i < source.columns; ++i) y_[row[i]] = x_[i];
    return source;
  }

  const FactorMemory& factor_;
  VectorXd& y_;
  VectorXd x_;
};

void solve_front_backward(const FactorMemory& factor, int s, VectorXd& y, VectorXd& x) {
  const Front source = factor.front(s);
  const int* row = factor.rows(s);
  for (int i = 0; i < source.rows; ++i) x[i] = y[row[i]];
  best_kernels().solve_backward(source, x.data());
  for (int i = 0; i < source.columns; ++i) y[row[i]] = x[i];
}

/// The columns of a task.
struct ColumnRange {
  int begin = 0;
  int end = 0;
  auto of(VectorXd& y) const { return y.segment(begin, end - begin); }
  auto of(const VectorXd& y) const { return y.segment(begin, end - begin); }
};

ColumnRange columns_of(const FactorMemory& factor, int t) {
  const auto [first, last] = factor.layout.tasks.tasks[t];
  const std::vector<int>& begin = factor.layout.fronts.column_begin;
  return {begin[first], begin[last]};
}

ColumnRange columns_of_front(const FactorMemory& factor, int s) {
  const std::vector<int>& begin = factor.layout.fronts.column_begin;
  return {begin[s], begin[s + 1]};
}

/// Takes over some of b, which is by row.
void take_columns(const FactorMemory& factor, ColumnRange columns, const VectorXd& b, VectorXd& y) {
  const std::vector<int>& order = factor.layout.fronts.order;
  for (int c = columns.begin; c < columns.end; ++c) y[c] = b[order[c]];
}

/// Hands some of y over to x, which is by row.
void give_columns(const FactorMemory& factor, ColumnRange columns, const VectorXd& y, VectorXd& x) {
  const std::vector<int>& order = factor.layout.fronts.order;
  for (int c = columns.begin; c < columns.end; ++c) x[order[c]] = y[c];
}

void solve_task(const FactorMemory& factor, int t, VectorXd& y, Eigen::MatrixXd& above) {
  above.col(t).setZero();
  ForwardSolve solve(factor, y);
  const auto [first, last] = factor.layout.tasks.tasks[t];
  const int end = columns_of(factor, t).end;
  for (int s = first; s < last; ++s) solve.solve_below(s, end, above.col(t).data());
}

/// The fronts above the tasks, after them.
void solve_top(const FactorMemory& factor, const VectorXd& b, const Eigen::MatrixXd& above,
               VectorXd& y) {
  const FrontTasks& tasks = factor.layout.tasks;
  VectorXd sum = VectorXd::Zero(tasks.top_columns);
  for (Eigen::Index t = 0; t < above.cols(); ++t) sum += above.col(t);
  ForwardSolve solve(factor, y);
  for (const int s : tasks.top) {
    const ColumnRange columns = columns_of_front(factor, s);
    take_columns(factor, columns, b, y);
    columns.of(y) += sum.segment(tasks.top_place[columns.begin], columns.end - columns.begin);
  }
  for (const int s : tasks.top) solve.solve_top(s);
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

VectorXd solve_forward(const FactorMemory& factor, const VectorXd& b) {
  const FrontTasks& tasks = factor.layout.tasks;
  const int count = static_cast<int>(tasks.tasks.size());
  VectorXd y(b.size());
  Eigen::MatrixXd above(tasks.top_columns, count);
  run_tasks(count, [&](int t) {
    take_columns(factor, columns_of(factor, t), b, y);
    solve_task(factor, t, y, above);
  });
  solve_top(factor, b, above, y);
  return y;
}

VectorXd solve_forward(const FactorMemory& factor, const VectorXd& b,
                       const std::vector<uint64_t>& version, ForwardSweep& last) {
  const FrontTasks& tasks = factor.layout.tasks;
  const int count = static_cast<int>(tasks.tasks.size());
  VectorXd y(b.size());
  const bool known = last.b.size() == y.size() && last.above.cols() == count &&
                     last.above.rows() == tasks.top_columns;
  if (!known) {
    last.version.assign(version.size(), 0);
    last.b.resize(y.size());
    last.y.resize(y.size());
    last.above.resize(tasks.top_columns, count);
  }
  run_tasks(count, [&](int t) {
    const ColumnRange columns = columns_of(factor, t);
    take_columns(factor, columns, b, y);
    if (last.version[t] != version[t] || columns.of(last.b) != columns.of(y)) {
      columns.of(last.b) = columns.of(y);
      solve_task(factor, t, y, last.above);
      columns.of(last.y) = columns.of(y);
      last.version[t] = version[t];
    }
    columns.of(y) = columns.of(last.y);
  });
  solve_top(factor, b, last.above, y);
  return y;
}

VectorXd solve_backward(const FactorMemory& factor, VectorXd y) {
  const FrontTasks& tasks = factor.layout.tasks;
  VectorXd solution = VectorXd::Zero(y.size());
  const auto solve = [&](int s, VectorXd& x) {
    solve_front_backward(factor, s, y, x);
    give_columns(factor, columns_of_front(factor, s), y, solution);
  };
  VectorXd x = VectorXd::Zero(padded(factor.layout.most_rows));
  for (size_t i = tasks.top.size(); i-- > 0;) solve(tasks.top[i], x);
  run_tasks(static_cast<int>(tasks.tasks.size()), [&](int t) {
    VectorXd own = VectorXd::Zero(padded(factor.layout.most_rows));
    for (int s = tasks.tasks[t].last - 1; s >= tasks.tasks[t].first; --s) solve(s, own);
  });
  return solution;
}

}  // namespace relievo
