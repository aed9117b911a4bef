#include "kernel/cholesky/triangular_solves.h"

#include "kernel/base/workers.h"

namespace relievo {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the columns of a range of fronts.
Range columns_of(const FactorMemory& factor, Range fronts) {
  const std::vector<int>& begin = factor.layout.fronts.column_begin;
  return {begin[fronts.begin], begin[fronts.end]};
}

/// Returns memory for the rows of any front, padded like a column.
VectorXd memory_for_rows(const FactorMemory& factor) {
  return VectorXd::Zero(padded(factor.layout.most_rows));
}

/// Solves with the columns of front s, in y. Leaves their contribution to the rows below in x, by
/// row of the front. Returns false, without doing anything, where y is 0 on the columns.
bool solve_columns(const FactorMemory& factor, int s, VectorXd& y, VectorXd& x) {
  const Range columns = columns_of(factor, {s, s + 1});
  if ((y.segment(columns.begin, columns.end - columns.begin).array() == 0).all()) return false;
  const Front front = factor.front(s);
  for (int i = 0; i < front.columns; ++i) x[i] = y[columns.begin + i];
  for (int i = front.columns; i < front.rows; ++i) x[i] = 0;
  best_kernels().solve_forward(front, x.data());
  for (int i = 0; i < front.columns; ++i) y[columns.begin + i] = x[i];
  return true;
}

/// Solves with the fronts of a task. Adds their contributions to the columns of top fronts to
/// `above`.
void solve_task(const FactorMemory& factor, Range task, VectorXd& y, double* above) {
  const Supernodes& fronts = factor.layout.fronts;
  const int end = columns_of(factor, task).end;
  VectorXd x = memory_for_rows(factor);
  for (int s = task.begin; s < task.end; ++s) {
    if (!solve_columns(factor, s, y, x)) continue;
    const int* row = factor.rows(s);
    const int rows = fronts.rows(s);
    int i = fronts.columns(s);
    for (; i < rows && row[i] < end; ++i) y[row[i]] += x[i];
    for (; i < rows; ++i) above[factor.layout.top_column[row[i]]] += x[i];
  }
}

/// Solves with the top fronts after all tasks, whose contributions are the columns of `above`.
void solve_top(const FactorMemory& factor, const VectorXd& b, const MatrixXd& above, VectorXd& y) {
  const FrontLayout& layout = factor.layout;
  VectorXd sum = VectorXd::Zero(layout.top_columns);
  for (Eigen::Index t = 0; t < above.cols(); ++t) sum += above.col(t);
  for (const int s : layout.top) {
    const Range columns = columns_of(factor, {s, s + 1});
    for (int c = columns.begin; c < columns.end; ++c)
      y[c] = b[layout.fronts.order[c]] + sum[layout.top_column[c]];
  }
  VectorXd x = memory_for_rows(factor);
  for (const int s : layout.top) {
    if (!solve_columns(factor, s, y, x)) continue;
    const int* row = factor.rows(s);
    for (int i = layout.fronts.columns(s); i < layout.fronts.rows(s); ++i) y[row[i]] += x[i];
  }
}

}  // namespace

VectorXd solve_forward(const FactorMemory& factor, const VectorXd& b) {
  const FrontLayout& layout = factor.layout;
  const int tasks = static_cast<int>(layout.tasks.size());
  VectorXd y(b.size());
  MatrixXd above = MatrixXd::Zero(layout.top_columns, tasks);
  run_tasks(tasks, [&](int t) {
    const Range columns = columns_of(factor, layout.tasks[t]);
    for (int c = columns.begin; c < columns.end; ++c) y[c] = b[layout.fronts.order[c]];
    solve_task(factor, layout.tasks[t], y, above.col(t).data());
  });
  solve_top(factor, b, above, y);
  return y;
}

VectorXd solve_backward(const FactorMemory& factor, VectorXd y) {
  const FrontLayout& layout = factor.layout;
  VectorXd solution(y.size());
  const auto solve = [&](int s, VectorXd& x) {
    const Front front = factor.front(s);
    const int* row = factor.rows(s);
    for (int i = 0; i < front.rows; ++i) x[i] = y[row[i]];
    best_kernels().solve_backward(front, x.data());
    for (int i = 0; i < front.columns; ++i) {
      y[row[i]] = x[i];
      solution[layout.fronts.order[row[i]]] = x[i];
    }
  };
  VectorXd x = memory_for_rows(factor);
  for (size_t i = layout.top.size(); i-- > 0;) solve(layout.top[i], x);
  run_tasks(static_cast<int>(layout.tasks.size()), [&](int t) {
    VectorXd own = memory_for_rows(factor);
    for (int s = layout.tasks[t].end - 1; s >= layout.tasks[t].begin; --s) solve(s, own);
  });
  return solution;
}

}  // namespace relievo
