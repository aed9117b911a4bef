#pragma once

#include <vector>

#include "relief/finish/find_ink.h"
#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// The place of a surface in a solid: scale * position + shift. The solid's texture coordinates lie
/// on the picture up to v = `pictured`, and on plain colours below.
struct SolidPlace {
  Point3 scale{1, 1, 1};
  Point3 shift;
  double pictured = 1;
  bool backed = false;  ///< whether its back is round, so that the shell alone draws the silhouette
};

/// Adds the shells of parts to a mesh: their surfaces once more, pushed out along the normals by
/// the width of their ink and turned inside out, with fewer triangles. The width is that of the
/// line beside an outline, and the usual one of the part farther in. `model`: a drawn-in surface,
/// or the solid of one at its place; its last parts may have no ink. `width`: a factor. `uvs`: of
/// the colour of each part. O(n log n) for n triangles.
void add_shells(const ContourInk& ink, const Model& model, const SolidPlace& place, double width,
                const std::vector<Point2>& uvs, InkMesh& mesh);

/// Returns a model whose vertices at one position are one, with the mean normal of the triangles
/// around it, so that its shell is as closed as the model. Texture coordinates are left out.
/// O(n log n).
Model weld(const Model& model);

}  // namespace relievo::relief
