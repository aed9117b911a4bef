#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/scene/scene.h"

namespace relievo {

/// Two faces of one base triangle of which the second must not lie below the first.
struct FacePair {
  int lower = -1;
  int upper = -1;
  friend bool operator==(const FacePair&, const FacePair&) = default;
};

/// Each face with the next one below it in the stack, which need not be that of an earlier part. A
/// face whose part has d < 0 is meant to lie below what it covers and has none; lower faces to
/// which a relation "free" without a range was given are passed over. O(F) but for such relations.
std::vector<FacePair> stacked_faces(const LayeredMesh& mesh, const Scene& scene);

/// How far upper faces dip below lower ones between the base vertices.
struct OverlapSamples {
  int count = 0;     ///< samples that dip by more than the tolerance
  double worst = 0;  ///< deepest of them, px
};

/// Samples g + sgn(u) sqrt|u|, u and g linear, at six inner points of every two stacked faces that
/// have no node in common. u in px^2; g and the tolerance in px. O(pairs).
OverlapSamples sample_overlap(const LayeredMesh& mesh, const std::vector<FacePair>& pairs,
                              const std::vector<double>& u, const std::vector<double>& g,
                              double tolerance);

}  // namespace relievo
