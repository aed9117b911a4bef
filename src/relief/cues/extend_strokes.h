#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "relief/cues/part_sheet.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Called with a triangle of a sheet, a cue, and the unit direction of a segment of its line that
/// meets the triangle.
using StrokeVisitor = std::function<void(int triangle, const Cue& cue, Point2 along)>;

/// Visits the triangles that the lines of a part's cues of one kind meet, cue by cue and segment by
/// segment. `scale` is that of the sheet. O(K * points of the lines).
void visit_strokes(const PartSheet& sheet, const Scene& scene, int part, CueKind kind, double scale,
                   const StrokeVisitor& visit);

/// Flags the parts that have a cue of one of the kinds.
std::vector<bool> parts_with(const Scene& scene, std::initializer_list<CueKind> kinds);

/// Computes the discrete harmonic functions x that have given values at fixed vertices and no flow
/// through the rest of the boundary:
///   (L x)_i = 0 at free vertices,  x_i = values_i where fixed.
/// `fixed` has #V flags, `values` #V rows and a column for each function; its other rows are not
/// read. Pieces of the mesh without a fixed vertex get `otherwise`. One factorisation.
Eigen::MatrixXd harmonic_extension(const FlatMesh& mesh, std::vector<uint8_t> fixed,
                                   Eigen::MatrixXd values, double otherwise);

/// Computes the function r with the gradient nearest to a field w that is constant on each triangle
/// (#F), #V:
///   r = argmin of the integral of |grad r - w|^2,  that is  (L r)_i = integral of w . grad phi_i,
/// with hat functions phi_i. Its mean is 0 on every piece of the mesh. One factorisation.
Eigen::VectorXd nearest_potential(const FlatMesh& mesh, const std::vector<Point2>& field);

}  // namespace relievo::relief
