#include "kernel/solvers/triangular_solves.h"

#include "kernel/base/workers.h"

namespace relievo {
namespace {

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

void solve_task(const FactorMemory& factor, int t, VectorXd& y, Eigen::MatrixXd& above) {
  ForwardSolve solve(factor, y);
  const auto [first, last] = factor.layout.tasks.tasks[t];
  const int end = columns_of(factor, t).end;
  for (int s = first; s < last; ++s) solve.solve_below(s, end, above.col(t).data());
}

/// The fronts above the tasks, after them.
void solve_top(const FactorMemory& factor, const Eigen::MatrixXd& above, VectorXd& y) {
  const FrontTasks& tasks = factor.layout.tasks;
  VectorXd sum = VectorXd::Zero(tasks.top_columns);
  for (Eigen::Index t = 0; t < above.cols(); ++t) sum += above.col(t);
  ForwardSolve solve(factor, y);
  for (const int s : tasks.top)
    for (int c = factor.layout.fronts.column_begin[s]; c < factor.layout.fronts.column_begin[s + 1];
         ++c)
      y[c] += sum[tasks.top_place[c]];
  for (const int s : tasks.top) solve.solve_top(s);
}

}  // namespace

void solve_forward(const FactorMemory& factor, VectorXd& y) {
  const FrontTasks& tasks = factor.layout.tasks;
  const int count = static_cast<int>(tasks.tasks.size());
  Eigen::MatrixXd above = Eigen::MatrixXd::Zero(tasks.top_columns, count);
  run_tasks(count, [&](int t) { solve_task(factor, t, y, above); });
  solve_top(factor, above, y);
}

void solve_forward(const FactorMemory& factor, const std::vector<uint64_t>& version,
                   ForwardSweep& last, VectorXd& y) {
  const FrontTasks& tasks = factor.layout.tasks;
  const int count = static_cast<int>(tasks.tasks.size());
  const bool known = last.b.size() == y.size() && last.above.cols() == count &&
                     last.above.rows() == tasks.top_columns;
  if (!known) last = {std::vector<uint64_t>(version.size(), 0), y, y, {}};
  if (!known) last.above.resize(tasks.top_columns, count);
  run_tasks(count, [&](int t) {
    const ColumnRange columns = columns_of(factor, t);
    if (last.version[t] != version[t] || columns.of(last.b) != columns.of(y)) {
      columns.of(last.b) = columns.of(y);
      last.above.col(t).setZero();
      solve_task(factor, t, y, last.above);
      columns.of(last.y) = columns.of(y);
      last.version[t] = version[t];
    }
    columns.of(y) = columns.of(last.y);
  });
  solve_top(factor, last.above, y);
}

void solve_backward(const FactorMemory& factor, VectorXd& y) {
  const FrontTasks& tasks = factor.layout.tasks;
  VectorXd x = VectorXd::Zero(padded(factor.layout.most_rows));
  for (size_t i = tasks.top.size(); i-- > 0;) solve_front_backward(factor, tasks.top[i], y, x);
  run_tasks(static_cast<int>(tasks.tasks.size()), [&](int t) {
    VectorXd own = VectorXd::Zero(padded(factor.layout.most_rows));
    for (int s = tasks.tasks[t].last - 1; s >= tasks.tasks[t].first; --s)
      solve_front_backward(factor, s, y, own);
  });
}

}  // namespace relievo
