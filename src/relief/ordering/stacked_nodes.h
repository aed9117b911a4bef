#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/ordering/overlap.h"

namespace relievo {

/// Nodes inside two parts of which the second must not lie below the first, and their faces.
struct StackedNodes {
  std::vector<FacePair> faces;
  std::vector<DepthPair> pairs;              ///< #P, by lower and upper node, each once
  std::vector<std::array<int, 3>> of_faces;  ///< #faces: pair at each corner, -1 where it is one
                                             ///< node, or a node lies on an outline
};

/// The pairs of nodes at the corners of stacked faces. O(N + faces).
StackedNodes stacked_nodes(const LayeredMesh& mesh, std::vector<FacePair> faces);

/// One flag per pair: those that cross by more than `tolerance`. h, #N, in its unit. O(P).
std::vector<uint8_t> crossed(const StackedNodes& stacked, const std::vector<double>& h,
                             double tolerance);

/// One flag per pair: those chosen, and those that a path of up to `rings` edges leads to.
/// O(rings * faces).
std::vector<uint8_t> grown(const StackedNodes& stacked, std::vector<uint8_t> chosen, int rings);

/// The flags of those of `pairs`, sorted like the stacked ones, that are stacked. O(P).
std::vector<uint8_t> flags_of(const StackedNodes& stacked, const std::vector<DepthPair>& pairs);

/// The pairs whose flag is set. O(P).
std::vector<DepthPair> flagged(const StackedNodes& stacked, const std::vector<uint8_t>& chosen);

}  // namespace relievo
