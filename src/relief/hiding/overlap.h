#pragma once

#include <array>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Two faces of one base triangle of which the first must not lie in front of the second.
struct FacePair {
  int lower = -1;
  int upper = -1;
};

/// Each face with the next one in front of it; those that a relation "free" without a range lets
/// pass are passed over. By base triangle, front to back. O(F) but for such relations.
std::vector<FacePair> stacked_faces(const LayeredMesh& mesh, const Scene& scene);

/// Each hidden face with the one in front of all at its base triangle, but for those that a
/// relation "free" without a range lets cross. By base triangle. O(F).
std::vector<FacePair> covered_faces(const LayeredMesh& mesh, const Scene& scene);

/// How far a lower face comes out in front of an upper one, negative where it stays behind.
struct Dip {
  double depth = 0;                ///< px
  std::array<double, 3> weight{};  ///< of the corners at that point
};

/// The deepest of six inner points; u and g linear, the root of u taken afterwards.
Dip worst_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering);

/// How far it does near corners and edges, where roots rise from outlines more steeply than any
/// face, px.
double rim_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
               const Ordering& ordering);

}  // namespace relievo::relief
