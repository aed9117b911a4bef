#pragma once

#include <array>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Two faces of one base triangle. The lower one must not lie in front of the upper one.
struct FacePair {
  int lower = -1;
  int upper = -1;
};

/// Pairs each face with the next one in front of it, skipping parts that a relation "free" without
/// a range lets cross. Sorted by base triangle, front to back. O(F) without such relations.
std::vector<FacePair> stacked_faces(const LayeredMesh& mesh, const Scene& scene);

/// Pairs each hidden face with the frontmost one at its base triangle, except where a relation
/// "free" without a range lets them cross. Sorted by base triangle. O(F).
std::vector<FacePair> covered_faces(const LayeredMesh& mesh, const Scene& scene);

/// The distance by which a lower face comes out in front of an upper one at a point.
struct Dip {
  double depth = 0;                ///< px, negative if it stays behind
  std::array<double, 3> weight{};  ///< barycentric coordinates of the point
};

/// Returns the largest dip at six inner points. Interpolates u and g and then takes the root of u.
Dip worst_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering);

/// Returns the largest dip near corners and edges, px. Beside an outline a root rises more steeply
/// than any face.
double rim_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
               const Ordering& ordering);

}  // namespace relievo::relief
