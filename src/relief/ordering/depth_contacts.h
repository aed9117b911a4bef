#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "kernel/geometry/point.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_problem.h"
#include "relief/ordering/stacked_nodes.h"

namespace relievo {

/// Where two parts may touch, and whether they do: a depth pair without its mesh.
struct DepthContact {
  int lower = -1;  ///< parts
  int upper = -1;
  bool inside = false;  ///< both nodes, not on an outline nor on the edge of a flap
  Point2 position;      ///< px
  bool closed = false;  ///< the nodes have the same height, or cross

  std::tuple<int, int, bool> group() const { return {lower, upper, inside}; }
};

/// The contacts of heights h, #N: the inequalities of the mesh and, inside parts, the closed pairs
/// and the open ones beside them. Heights alone decide, not the way in which they were found.
/// O(constraints + stacked faces).
std::vector<DepthContact> contacts_of(const LayeredMesh& mesh, const StackedNodes& stacked,
                                      const std::vector<double>& h);

/// A first guess for a problem on another mesh of a similar scene, one flag per node: each gap
/// is as the nearest contact of the same parts, of its kind, open where there is none. O(gaps log
/// contacts) where contacts are not stacked above each other on the canvas.
std::vector<uint8_t> gaps_like(const LayeredMesh& mesh, const DepthProblem& problem,
                               std::vector<DepthContact> contacts);

/// Those of the stacked pairs whose nearest contact of the same parts is closed, in their order.
/// O(pairs log contacts) where contacts are not stacked above each other on the canvas.
std::vector<DepthPair> pairs_like(const LayeredMesh& mesh, const StackedNodes& stacked,
                                  std::vector<DepthContact> contacts);

}  // namespace relievo
