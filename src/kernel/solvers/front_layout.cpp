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
  layout.front_of.resize(fronts.order.size());
  for (int s = 0; s < fronts.size(); ++s) {
    const Front front{fronts.rows(s), fronts.columns(s)};
    layout.panel_begin.push_back(layout.panel_begin.back() + front.stride() * front.columns);
    layout.most_rows = std::max(layout.most_rows, front.rows);
    for (int c = fronts.column_begin[s]; c < fronts.column_begin[s + 1]; ++c)
      layout.front_of[fronts.order[c]] = s;
  }
}

void place_updates(FrontLayout& layout, Updates updates) {
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
    if (updates == Updates::stacked && layout.first_child[s] >= 0)
      used[1 - stack] = layout.update_begin[layout.first_child[s]];
  }
}

/// Index of the diagonal entry of each column in the values of A, -1 where it is missing.
std::vector<int> diagonal_sources(const SparseMatrix& A) {
  std::vector<int> source(static_cast<size_t>(A.outerSize()), -1);
  for (int j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(A, j); entry && source[j] < 0; ++entry)
      if (entry.row() == j) source[j] = static_cast<int>(&entry.value() - A.valuePtr());
  return source;
}

/// Lists the matrix's entries in one front, of whose rows `position` holds the places.
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

/// Entries go to panels, and rows to those of parents: both need the place of each row of the
/// matrix in the front, which is -1 where the row was eliminated before.
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
                    Updates updates) {
  FrontLayout layout;
  layout.fronts = std::move(fronts);
  link_children(layout);
  place_panels(layout);
  place_updates(layout, updates);
  connect_rows(A, graph, layout);
  return layout;
}

}  // namespace relievo
