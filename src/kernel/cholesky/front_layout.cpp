#include "kernel/cholesky/front_layout.h"

#include <algorithm>
#include <array>
#include <utility>

#include "kernel/cholesky/frontal_kernels.h"

namespace relievo {
namespace {

/// Largest share of all arithmetic in one task.
constexpr double largest_share = 1.0 / 16;
/// Multiplications of a factorisation below which threads do not pay.
constexpr double least_shared_work = 2e6;

/// Estimates the multiplications of the elimination of each front, #S.
std::vector<double> work_of_fronts(const Supernodes& fronts) {
  std::vector<double> work;
  work.reserve(fronts.parent.size());
  for (int s = 0; s < fronts.size(); ++s) {
    double sum = 0;
    for (int c = 0; c < fronts.columns(s); ++c) {
      const double below = fronts.rows(s) - c;
      sum += 0.5 * below * below;
    }
    work.push_back(sum);
  }
  return work;
}

/// Groups the top fronts by the length of the longest way down from each through top fronts.
std::vector<std::vector<int>> levels_of(const std::vector<int>& top, const Supernodes& fronts) {
  std::vector<std::vector<int>> levels;
  std::vector<size_t> level(fronts.parent.size(), 0);
  for (const int s : top) {
    if (level[s] == levels.size()) levels.emplace_back();
    levels[level[s]].push_back(s);
    if (const int parent = fronts.parent[s]; parent >= 0)
      level[parent] = std::max(level[parent], level[s] + 1);
  }
  return levels;
}

using Eigen::Index;

/// Divides the fronts into tasks, each with at most a small share of the arithmetic, and top
/// fronts. Where there is little arithmetic in all, it is one task. O(S + n).
void split_into_tasks(FrontLayout& layout) {
  const Supernodes& fronts = layout.fronts;
  std::vector<double> subtree = work_of_fronts(fronts);
  double total = 0;
  for (const double work : subtree) total += work;
  for (int s = 0; s < fronts.size(); ++s)
    if (fronts.parent[s] >= 0) subtree[fronts.parent[s]] += subtree[s];
  const double limit = total < least_shared_work ? total : largest_share * total;

  layout.top_column.assign(fronts.order.size(), -1);
  double gathered = 0;
  bool open = false;
  for (int s = 0; s < fronts.size(); ++s) {
    if (subtree[s] > limit) {
      layout.top.push_back(s);
      for (int c = fronts.column_begin[s]; c < fronts.column_begin[s + 1]; ++c)
        layout.top_column[c] = layout.top_columns++;
      open = false;
      continue;
    }
    if (!open) layout.tasks.push_back({s, s});
    if (!open) gathered = 0;
    layout.tasks.back().end = s + 1;
    const bool root = fronts.parent[s] < 0 || subtree[fronts.parent[s]] > limit;
    if (root) gathered += subtree[s];
    open = !root || gathered < 0.5 * limit;
  }
  layout.top_levels = levels_of(layout.top, fronts);
}

void link_children(FrontLayout& layout) {
  const Supernodes& fronts = layout.fronts;
  layout.first_child.assign(fronts.parent.size(), -1);
  layout.next_sibling = layout.first_child;
  for (int s = fronts.size() - 1; s >= 0; --s) {
    if (fronts.parent[s] < 0) continue;
    int& first = layout.first_child[fronts.parent[s]];
    layout.next_sibling[s] = first;
    first = s;
  }
}

void place_panels(FrontLayout& layout) {
  const Supernodes& fronts = layout.fronts;
  layout.panel_begin = {0};
  layout.front_of.resize(fronts.order.size());
  for (int s = 0; s < fronts.size(); ++s) {
    const Front front{fronts.rows(s), fronts.columns(s)};
    layout.panel_begin.push_back(layout.panel_begin.back() + front.stride() * front.columns);
    layout.most_rows = std::max(layout.most_rows, front.rows);
    for (int c = fronts.column_begin[s]; c < fronts.column_begin[s + 1]; ++c)
      layout.front_of[fronts.order[c]] = s;
  }
}

Index update_size(const Supernodes& fronts, int s) {
  return Front{fronts.rows(s), fronts.columns(s)}.update_size();
}

/// Gives the update of front s a place of its own.
void keep_update(FrontLayout& layout, int s) {
  layout.update_begin[s] = layout.updates_size;
  layout.updates_size += update_size(layout.fronts, s);
}

/// Places the updates of a task on its two stacks, behind those placed before. `parity`: of the
/// depth of each front.
void stack_updates(FrontLayout& layout, Range task, const std::vector<int>& parity) {
  const Supernodes& fronts = layout.fronts;
  std::array<Index, 2> used = {0, 0};
  std::array<Index, 2> most = {0, 0};
  const auto leaves_task = [&](int s) {
    return fronts.parent[s] < 0 || fronts.parent[s] >= task.end;
  };
  for (int s = task.begin; s < task.end; ++s) {
    const int stack = parity[s];
    if (!leaves_task(s)) {
      layout.update_begin[s] = used[stack];
      used[stack] += update_size(fronts, s);
      most[stack] = std::max(most[stack], used[stack]);
    }
    if (layout.first_child[s] >= 0) used[1 - stack] = layout.update_begin[layout.first_child[s]];
  }
  for (int s = task.begin; s < task.end; ++s)
    if (!leaves_task(s))
      layout.update_begin[s] += layout.updates_size + (parity[s] != 0 ? most[0] : 0);
  layout.updates_size += most[0] + most[1];
  for (int s = task.begin; s < task.end; ++s)
    if (leaves_task(s)) keep_update(layout, s);
}

void place_updates(FrontLayout& layout, bool keep) {
  const Supernodes& fronts = layout.fronts;
  layout.update_begin.assign(fronts.parent.size(), 0);
  if (keep) {
    for (int s = 0; s < fronts.size(); ++s) keep_update(layout, s);
    return;
  }
  std::vector<int> parity(fronts.parent.size(), 0);
  for (int s = fronts.size() - 1; s >= 0; --s)
    if (fronts.parent[s] >= 0) parity[s] = 1 - parity[fronts.parent[s]];
  for (const Range task : layout.tasks) stack_updates(layout, task, parity);
  for (const int s : layout.top) keep_update(layout, s);
}

/// Finds the diagonal entry of each column in the values of A, -1 where it is missing.
std::vector<int> diagonal_sources(const SparseMatrix& A) {
  std::vector<int> source(static_cast<size_t>(A.outerSize()), -1);
  for (int j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(A, j); entry && source[j] < 0; ++entry)
      if (entry.row() == j) source[j] = static_cast<int>(&entry.value() - A.valuePtr());
  return source;
}

/// Lists the entries of the matrix in one front. `position`: index of each row of the matrix in the
/// front, -1 for those eliminated before.
void list_entries(const SymmetricGraph& graph, const std::vector<int>& diagonal, int front,
                  const std::vector<int>& position, FrontLayout& layout) {
  const Supernodes& fronts = layout.fronts;
  const Index stride = Front{fronts.rows(front), fronts.columns(front)}.stride();
  for (int c = 0; c < fronts.columns(front); ++c) {
    const int j = fronts.order[fronts.column_begin[front] + c];
    if (diagonal[j] >= 0) layout.entries.push_back({diagonal[j], c * stride + c});
    for (int p = graph.begin[j]; p < graph.begin[j + 1]; ++p) {
      const int row = position[graph.neighbour[p]];
      if (row > c) layout.entries.push_back({graph.source[p], c * stride + row});
    }
  }
  layout.entry_begin.push_back(static_cast<Index>(layout.entries.size()));
}

/// Maps the entries of the matrix to panels, and the rows of each front to those of its parent.
void connect_rows(const SparseMatrix& A, const SymmetricGraph& graph, FrontLayout& layout) {
  const Supernodes& fronts = layout.fronts;
  const std::vector<int> diagonal = diagonal_sources(A);
  std::vector<int> position(fronts.order.size());
  layout.row_in_parent.resize(fronts.row.size(), -1);
  layout.entries.reserve(static_cast<size_t>(A.nonZeros()));
  layout.entry_begin = {0};
  for (int s = 0; s < fronts.size(); ++s) {
    for (Index r = fronts.row_begin[s]; r < fronts.row_begin[s + 1]; ++r)
      position[fronts.order[fronts.row[r]]] = static_cast<int>(r - fronts.row_begin[s]);
    list_entries(graph, diagonal, s, position, layout);
    for (int child = layout.first_child[s]; child >= 0; child = layout.next_sibling[child])
      for (Index r = fronts.row_begin[child] + fronts.columns(child);
           r < fronts.row_begin[child + 1]; ++r)
        layout.row_in_parent[r] = position[fronts.order[fronts.row[r]]];
    for (int c = fronts.column_begin[s]; c < fronts.column_begin[s + 1]; ++c)
      position[fronts.order[c]] = -1;
  }
}

}  // namespace

FrontLayout lay_out(const SparseMatrix& A, const SymmetricGraph& graph, Supernodes fronts,
                    bool keep_updates) {
  FrontLayout layout;
  layout.fronts = std::move(fronts);
  split_into_tasks(layout);
  link_children(layout);
  place_panels(layout);
  place_updates(layout, keep_updates);
  connect_rows(A, graph, layout);
  return layout;
}

}  // namespace relievo
