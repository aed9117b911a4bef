#include "kernel/solvers/front_layout.h"

#include <algorithm>

#include "kernel/solvers/frontal_kernels.h"

namespace relievo {
namespace {

using Eigen::Index;

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
  for (int s = 0; s < fronts.size(); ++s) {
    const Front front{fronts.rows(s), fronts.columns(s)};
    layout.panel_begin.push_back(layout.panel_begin.back() + front.stride() * front.columns);
    layout.most_rows = std::max(layout.most_rows, front.rows);
  }
}

void place_updates(FrontLayout& layout) {
  const Supernodes& fronts = layout.fronts;
  layout.stack.assign(fronts.parent.size(), 0);
  for (int s = fronts.size() - 1; s >= 0; --s)
    if (fronts.parent[s] >= 0) layout.stack[s] = 1 - layout.stack[fronts.parent[s]];
  std::array<Index, 2> used = {0, 0};
  for (int s = 0; s < fronts.size(); ++s) {
    const int stack = layout.stack[s];
    layout.update_begin.push_back(used[stack]);
    used[stack] += static_cast<Index>(Front{fronts.rows(s), fronts.columns(s)}.update_size());
    layout.stack_size[stack] = std::max(layout.stack_size[stack], used[stack]);
    if (layout.first_child[s] >= 0) used[1 - stack] = layout.update_begin[layout.first_child[s]];
  }
}

/// Position of each row of the matrix among the rows of one front.
void mark_rows(const Supernodes& fronts, int front, std::vector<int>& position) {
  for (Index r = fronts.row_begin[front]; r < fronts.row_begin[front + 1]; ++r)
    position[fronts.row[r]] = static_cast<int>(r - fronts.row_begin[front]);
}

/// The entries of A by the column in which they are eliminated: begin and, for each, its row and
/// source.
struct EntriesByColumn {
  struct Entry {
    int row;
    int source;
  };
  std::vector<int> begin;
  std::vector<Entry> entries;
};

EntriesByColumn entries_by_column(const SparseMatrix& A, const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (size_t i = 0; i < order.size(); ++i) position[order[i]] = static_cast<int>(i);
  const auto for_each_entry = [&](auto&& visit) {
    for (int j = 0; j < A.outerSize(); ++j)
      for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry) {
        if (entry.row() < j) continue;
        const auto [low, high] = std::minmax({position[j], position[entry.row()]});
        visit(low, high, static_cast<int>(&entry.value() - A.valuePtr()));
      }
  };
  EntriesByColumn result;
  result.begin.assign(order.size() + 1, 0);
  for_each_entry([&](int column, int, int) { ++result.begin[column + 1]; });
  for (size_t j = 0; j < order.size(); ++j) result.begin[j + 1] += result.begin[j];
  result.entries.resize(static_cast<size_t>(result.begin.back()));
  std::vector<int> next(result.begin.begin(), result.begin.end() - 1);
  for_each_entry([&](int column, int row, int source) {
    result.entries[next[column]++] = {row, source};
  });
  return result;
}

/// Entries go to panels, and rows to those of parents: both need the rows of a front marked.
void connect_rows(const SparseMatrix& A, FrontLayout& layout) {
  const Supernodes& fronts = layout.fronts;
  const EntriesByColumn sources = entries_by_column(A, fronts.order);
  std::vector<int> position(fronts.order.size());
  layout.row_in_parent.resize(fronts.row.size(), -1);
  layout.entries.reserve(sources.entries.size());
  layout.entry_begin = {0};
  for (int s = 0; s < fronts.size(); ++s) {
    mark_rows(fronts, s, position);
    const Index stride = Front{fronts.rows(s), fronts.columns(s)}.stride();
    for (int j = fronts.column_begin[s]; j < fronts.column_begin[s + 1]; ++j)
      for (int p = sources.begin[j]; p < sources.begin[j + 1]; ++p)
        layout.entries.push_back({sources.entries[p].source, (j - fronts.column_begin[s]) * stride +
                                                                 position[sources.entries[p].row]});
    layout.entry_begin.push_back(static_cast<Index>(layout.entries.size()));
    for (int child = layout.first_child[s]; child >= 0; child = layout.next_sibling[child])
      for (Index r = fronts.row_begin[child] + fronts.columns(child);
           r < fronts.row_begin[child + 1]; ++r)
        layout.row_in_parent[r] = position[fronts.row[r]];
  }
}

}  // namespace

FrontLayout lay_out(const SparseMatrix& A, Supernodes fronts) {
  FrontLayout layout;
  layout.fronts = std::move(fronts);
  link_children(layout);
  place_panels(layout);
  place_updates(layout);
  connect_rows(A, layout);
  return layout;
}

}  // namespace relievo
