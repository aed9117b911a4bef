#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/geometry/triangles.h"
#include "relief/cues/part_sheet.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A triangle of a sheet that a segment of a cue's line meets.
struct StrokeContact {
  int triangle = -1;  ///< of the sheet
  const Cue* cue = nullptr;
  Point2 along;  ///< unit direction of the segment
};

/// All triangles that lines of the scene's cues of a kind on `part` meet. `scale`: that of the
/// sheet. O(K * points of the lines).
std::vector<StrokeContact> stroke_contacts(const PartSheet& sheet, const Scene& scene, int part,
                                           CueKind kind, double scale);

/// Which parts have a cue of one of the kinds, #parts.
std::vector<bool> parts_with(const Scene& scene, std::initializer_list<CueKind> kinds);

/// The discrete harmonic functions with the given values (#V x any number of columns, of which
/// other rows are not read) where `fixed` (#V flags), and no flow through the rest of the boundary.
/// `otherwise` on pieces of the mesh without a fixed vertex. One factorisation.
Eigen::MatrixXd harmonic_extension(const FlatMesh& mesh, std::vector<uint8_t> fixed,
                                   Eigen::MatrixXd values, double otherwise);

/// The function whose gradient is nearest to a field that is constant on each triangle (#F), in the
/// mean square; its mean is 0 on every piece of the mesh. #V. One factorisation.
Eigen::VectorXd nearest_potential(const FlatMesh& mesh, const std::vector<Point2>& field);

}  // namespace relievo::relief
