#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_problem.h"
#include "relievo/point.h"

namespace relievo::relief {

/// Where two parts may touch, and whether they do: a depth pair without its mesh.
struct DepthContact {
  int lower = -1;  ///< parts
  int upper = -1;
  bool inside = false;  ///< both nodes, not on an outline
  Point2 position;      ///< px
  bool closed = false;  ///< the nodes have the same height, or cross

  std::tuple<int, int, bool> group() const { return {lower, upper, inside}; }
};

/// The contacts of heights h, #N, where the mesh has inequalities. Heights alone decide, not the
/// way in which they were found. O(constraints).
std::vector<DepthContact> contacts_of(const LayeredMesh& mesh, const std::vector<double>& h);

/// A first guess for a problem on another mesh of a similar scene, one flag per node: each gap
/// is as the nearest contact of the same parts and kind, open where there is none. O(gaps log
/// contacts) where contacts are not stacked above each other on the canvas.
std::vector<uint8_t> gaps_like(const LayeredMesh& mesh, const DepthProblem& problem,
                               std::vector<DepthContact> contacts);

}  // namespace relievo::relief
