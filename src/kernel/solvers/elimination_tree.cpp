#include "kernel/solvers/elimination_tree.h"

#include <numeric>

namespace relievo {
namespace {

/// Smallest column of the subtree of each column of a postordered tree.
std::vector<int> first_descendants(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<int> first(parent.size(), n);
  for (int j = 0; j < n; ++j) {
    if (first[j] == n) first[j] = j;
    if (parent[j] >= 0 && first[j] < first[parent[j]]) first[parent[j]] = first[j];
  }
  return first;
}

/// Finds the leaves of the row subtrees, column by column. Row i of the factor is the subtree whose
/// leaves are the columns reported for it; consecutive leaves overlap from their common ancestor.
class RowSubtrees {
 public:
  explicit RowSubtrees(const std::vector<int>& parent)
      : first_(first_descendants(parent)), last_first_(parent.size(), -1), last_leaf_(last_first_) {
    ancestor_.resize(parent.size());
    std::iota(ancestor_.begin(), ancestor_.end(), 0);
  }

  bool add_leaf(int row, int column) {
    if (first_[column] <= last_first_[row]) return false;
    last_first_[row] = first_[column];
    return true;
  }

  /// Where the path from the new leaf joins the paths of the row's former leaves; -1 for the first.
  int meeting_point(int row, int column) {
    const int former = last_leaf_[row];
    last_leaf_[row] = column;
    return former < 0 ? -1 : find(former);
  }

  void finish(int column, int parent) {
    if (parent >= 0) ancestor_[column] = parent;
  }

 private:
  int find(int column) {
    int root = column;
    while (ancestor_[root] != root) root = ancestor_[root];
    while (ancestor_[column] != root) {
      const int next = ancestor_[column];
      ancestor_[column] = root;
      column = next;
    }
    return root;
  }

  std::vector<int> first_;
  std::vector<int> last_first_;
  std::vector<int> last_leaf_;
  std::vector<int> ancestor_;
};

}  // namespace

std::vector<int> elimination_tree(const SymmetricGraph& graph, const std::vector<int>& order) {
  const std::vector<int> position = positions_in(order);
  std::vector<int> parent(order.size(), -1);
  std::vector<int> ancestor(parent);
  for (int j = 0; j < graph.size(); ++j)
    for (int p = graph.begin[order[j]]; p < graph.begin[order[j] + 1]; ++p)
      for (int i = position[graph.neighbour[p]]; i >= 0 && i < j;) {
        const int next = ancestor[i];
        ancestor[i] = j;
        if (next < 0) parent[i] = j;
        i = next;
      }
  return parent;
}

std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<int> size(parent.size(), 1);
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) size[parent[j]] += size[j];
  std::vector<int> next(parent.size());
  std::vector<int> order(parent.size());
  int roots = n;
  for (int j = n - 1; j >= 0; --j) {
    int& end = parent[j] < 0 ? roots : next[parent[j]];
    order[end - 1] = j;
    next[j] = end - 1;
    end -= size[j];
  }
  return order;
}

std::vector<int> column_counts(const SymmetricGraph& graph, const std::vector<int>& order,
                               const std::vector<int>& parent) {
  const int n = graph.size();
  const std::vector<int> position = positions_in(order);
  RowSubtrees subtrees(parent);
  std::vector<int> count(parent.size(), 1);
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) count[parent[j]] = 0;
  for (int j = 0; j < n; ++j) {
    if (parent[j] >= 0) --count[parent[j]];
    for (int p = graph.begin[order[j]]; p < graph.begin[order[j] + 1]; ++p) {
      const int row = position[graph.neighbour[p]];
      if (row < j || !subtrees.add_leaf(row, j)) continue;
      ++count[j];
      const int meeting = subtrees.meeting_point(row, j);
      if (meeting >= 0) --count[meeting];
    }
    subtrees.finish(j, parent[j]);
  }
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) count[parent[j]] += count[j];
  return count;
}

}  // namespace relievo
