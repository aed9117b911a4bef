#include "understanding/areas/boosted_trees.h"

namespace relievo::understanding {

double sum_of_leaves(std::span<const TreeNode> nodes, std::span<const double> features) {
  double sum = 0;
  for (size_t root = 0; root < nodes.size();) {
    size_t node = root;
    while (nodes[node].feature >= 0)
      node = features[nodes[node].feature] <= nodes[node].value ? node + 1 : nodes[node].right;
    sum += nodes[node].value;
    // The last leaf of a tree is the one to the right of all nodes.
    size_t last = root;
    while (nodes[last].feature >= 0) last = nodes[last].right;
    root = last + 1;
  }
  return sum;
}

}  // namespace relievo::understanding
