#pragma once

#include <vector>

#include "relief/finish/find_ink.h"
#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// Adds the shells of parts to a mesh: their surfaces once more, pushed out along the normals by
/// the width of their ink and turned inside out, with fewer triangles. `scale`: what a width of one
/// canvas px becomes in the model. `uvs`: of the colour of each part. The last parts of the model
/// may have no ink. O(n log n) for n triangles.
void add_shells(const std::vector<PartInk>& parts, const Model& model, double scale,
                const std::vector<Point2>& uvs, InkMesh& mesh);

/// Returns a model whose vertices at one position are one, with the mean normal of the triangles
/// around it, so that its shell is as closed as the model. Texture coordinates are left out.
/// O(n log n).
Model weld(const Model& model);

}  // namespace relievo::relief
