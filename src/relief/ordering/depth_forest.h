#pragma once

#include <cstdint>
#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo {

/// h[child] = h[parent] + sign * gap with gap >= 0; parent and child are representatives.
struct DepthGap {
  int parent = -1;
  int child = -1;
  int sign = 1;
};

/// Depth pairs as merged nodes and a forest of gaps: any values for the roots and any gaps >= 0
/// give heights that satisfy all pairs.
struct DepthForest {
  std::vector<int> representative;  ///< #N: smallest node of the same height
  std::vector<DepthGap> gaps;       ///< a parent comes before its children
};

/// Merges equalities and cycles (a <= b <= a), drops repeated and implied pairs and roots the rest
/// in the middle of each tree. Where pairs of one base vertex still form an undirected cycle, their
/// nodes are put in one chain that implies the pairs, in the order of parts as far as the pairs
/// allow: stronger than asked for, but consistent. `node_part` has #N entries.
/// O(N + P log P) for P pairs, and k^3 / 64 where k nodes of a vertex are linked in a cycle.
DepthForest build_depth_forest(const std::vector<int>& node_part,
                               const std::vector<DepthPair>& pairs);

}  // namespace relievo
