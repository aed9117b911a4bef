#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_forest.h"
#include "relievo/point.h"

namespace relievo::relief {

/// A point where two parts may touch: a depth pair that does not depend on the mesh.
struct DepthContact {
  int lower = -1;       ///< part
  int upper = -1;       ///< part
  bool inside = false;  ///< whether both nodes lie off outlines
  Point2 position;      ///< px
  bool closed = false;  ///< whether the nodes have the same height, or cross

  std::tuple<int, int, bool> group() const { return {lower, upper, inside}; }
};

/// Returns the contacts of heights h (#N) at the inequalities of the mesh. They depend on the
/// heights alone, not on the active set of the solver. O(constraints).
std::vector<DepthContact> contacts_of(const LayeredMesh& mesh, const std::vector<double>& h);

/// Returns a first active set, #N flags, from the contacts of a similar scene on another mesh. Each
/// gap is closed if the nearest contact of the same parts and kind is, and open if there is none.
/// O(gaps log contacts) unless contacts are stacked above each other on the canvas.
std::vector<uint8_t> gaps_like(const LayeredMesh& mesh, const DepthForest& forest,
                               std::vector<DepthContact> contacts);

}  // namespace relievo::relief
