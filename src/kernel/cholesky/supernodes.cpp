#include "kernel/cholesky/supernodes.h"

#include <algorithm>
#include <numeric>

namespace relievo {
namespace {

/// Returns order[by[i]] for each i.
std::vector<int> renumbered(const std::vector<int>& order, const std::vector<int>& by) {
  std::vector<int> result;
  result.reserve(order.size());
  for (const int i : by) result.push_back(order[i]);
  return result;
}

/// A supernode while it may still be merged into its parent.
struct Group {
  double entries = 0;  ///< of the factor, without the zeros that merging stores
  int columns = 0;
  int rows = 0;
  int parent = -1;
  int merged_into = -1;
};

/// Finds the maximal supernodes of a postordered tree. Writes group_of[j], the one of column j.
std::vector<Group> maximal_supernodes(const std::vector<int>& parent, const std::vector<int>& count,
                                      std::vector<int>& group_of) {
  std::vector<Group> groups;
  group_of.reserve(parent.size());
  for (size_t j = 0; j < parent.size(); ++j) {
    const bool joins =
        j > 0 && parent[j - 1] == static_cast<int>(j) && count[j - 1] == count[j] + 1;
    if (!joins) {
      groups.emplace_back();
      groups.back().rows = count[j];
    }
    group_of.push_back(static_cast<int>(groups.size()) - 1);
    groups.back().columns += 1;
    groups.back().entries += count[j];
    groups.back().parent = parent[j];
  }
  for (Group& group : groups)
    if (group.parent >= 0) group.parent = group_of[group.parent];
  return groups;
}

/// Unites a child with its parent, which has all rows below the child's columns.
Group united(const Group& child, const Group& parent) {
  Group result = parent;
  result.columns += child.columns;
  result.rows += child.columns;
  result.entries += child.entries;
  return result;
}

/// Returns whether a merged front stores few enough zeros. Small fronts may store more, as their
/// number costs more than their zeros.
bool dense_enough(const Group& group) {
  const double w = group.columns;
  const double stored = w * group.rows - 0.5 * w * (w - 1);
  const double zeros = (stored - group.entries) / stored;
  if (group.columns <= 4) return true;
  if (group.columns <= 16) return zeros < 0.3;
  if (group.columns <= 48) return zeros < 0.1;
  return zeros < 0.05;
}

/// Merges groups into their parents, bottom up.
void merge_into_parents(std::vector<Group>& groups) {
  std::vector<int> last_child(groups.size(), -1);
  std::vector<int> sibling(groups.size(), -1);
  for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
    for (int child = last_child[g]; child >= 0; child = sibling[child]) {
      const Group candidate = united(groups[child], groups[g]);
      if (!dense_enough(candidate)) continue;
      groups[g] = candidate;
      groups[child].merged_into = g;
    }
    const int parent = groups[g].parent;
    if (parent < 0) continue;
    sibling[g] = last_child[parent];
    last_child[parent] = g;
  }
}

/// Makes fronts of the groups that are left, in their order, which is still a postorder: sets the
/// columns, the numbers of rows and the parents. Returns the former column of each column.
std::vector<int> gather_columns(const std::vector<Group>& groups, const std::vector<int>& group_of,
                                Supernodes& result) {
  std::vector<int> top(groups.size());
  std::vector<int> front_of(groups.size(), -1);
  for (int g = static_cast<int>(groups.size()) - 1; g >= 0; --g)
    top[g] = groups[g].merged_into < 0 ? g : top[groups[g].merged_into];
  result.column_begin = {0};
  result.row_begin = {0};
  for (size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].merged_into >= 0) continue;
    front_of[g] = static_cast<int>(result.column_begin.size()) - 1;
    result.column_begin.push_back(result.column_begin.back() + groups[g].columns);
    result.row_begin.push_back(result.row_begin.back() + groups[g].rows);
  }
  for (const Group& group : groups)
    if (group.merged_into < 0)
      result.parent.push_back(group.parent < 0 ? -1 : front_of[top[group.parent]]);

  std::vector<int> next(result.column_begin.begin(), result.column_begin.end() - 1);
  std::vector<int> former(group_of.size());
  for (size_t j = 0; j < group_of.size(); ++j)
    former[next[front_of[top[group_of[j]]]]++] = static_cast<int>(j);
  return former;
}

/// Lists the rows of each front. Row i belongs to all fronts on the paths up the tree from its
/// earlier neighbours to itself. Rows are added one after the other, so they ascend.
void collect_rows(const SymmetricGraph& graph, Supernodes& fronts) {
  const std::vector<int> position = positions_in(fronts.order);
  std::vector<int> front_of(fronts.order.size());
  for (int s = 0; s < fronts.size(); ++s)
    std::fill_n(front_of.begin() + fronts.column_begin[s], fronts.columns(s), s);
  fronts.row.resize(static_cast<size_t>(fronts.row_begin.back()));
  std::vector<Eigen::Index> next(fronts.row_begin.begin(), fronts.row_begin.end() - 1);
  std::vector<int> last_row(fronts.parent.size(), -1);
  for (int i = 0; i < static_cast<int>(fronts.order.size()); ++i) {
    const auto add_to = [&](int s) {
      fronts.row[next[s]++] = i;
      last_row[s] = i;
    };
    add_to(front_of[i]);
    const int row = fronts.order[i];
    for (int p = graph.begin[row]; p < graph.begin[row + 1]; ++p) {
      const int j = position[graph.neighbour[p]];
      if (j > i) continue;
      for (int s = front_of[j]; last_row[s] != i; s = fronts.parent[s]) add_to(s);
    }
  }
}

/// Finds the smallest column of the subtree of each column of a postordered tree.
std::vector<int> first_descendants(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<int> first(parent.size(), n);
  for (int j = 0; j < n; ++j) {
    if (first[j] == n) first[j] = j;
    if (parent[j] >= 0 && first[j] < first[parent[j]]) first[parent[j]] = first[j];
  }
  return first;
}

/// Finds the leaves of the row subtrees, column by column. The entries of row i of the factor form
/// the subtree spanned by its leaves and i; the paths from consecutive leaves join at their least
/// common ancestor.
class RowSubtrees {
 public:
  explicit RowSubtrees(const std::vector<int>& parent)
      : first_(first_descendants(parent)), last_first_(parent.size(), -1), last_leaf_(last_first_) {
    ancestor_.resize(parent.size());
    std::iota(ancestor_.begin(), ancestor_.end(), 0);
  }

  /// Returns whether the column is a leaf of the row's subtree, and notes it if so.
  bool add_leaf(int row, int column) {
    if (first_[column] <= last_first_[row]) return false;
    last_first_[row] = first_[column];
    return true;
  }

  /// Returns the column where the path from a new leaf joins those of the row's former leaves; -1
  /// for the first leaf.
  int meeting_point(int row, int column) {
    const int former = last_leaf_[row];
    last_leaf_[row] = column;
    return former < 0 ? -1 : find(former);
  }

  /// Ends the visit of a column.
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

Supernodes make_supernodes(const SymmetricGraph& graph, const std::vector<int>& order,
                           const RunContext& context) {
  const std::vector<int> tree = elimination_tree(graph, order);
  const std::vector<int> post = postorder(tree);
  const std::vector<int> position = positions_in(post);
  std::vector<int> parent;
  parent.reserve(tree.size());
  for (const int j : post) parent.push_back(tree[j] < 0 ? -1 : position[tree[j]]);
  Supernodes result;
  result.order = renumbered(order, post);
  if (context.cancelled()) return result;

  std::vector<int> group_of;
  std::vector<Group> groups =
      maximal_supernodes(parent, column_counts(graph, result.order, parent), group_of);
  if (context.cancelled()) return result;
  merge_into_parents(groups);
  result.order = renumbered(result.order, gather_columns(groups, group_of, result));
  collect_rows(graph, result);
  return result;
}

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
