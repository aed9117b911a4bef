#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

/// Keeps the ink of outer contours narrow when the model is turned. Surfaces stand upright at
/// their outlines, so that ink as wide as w px there reaches sqrt(2 R w) deep, a broad dark band.
/// Parts most of whose silhouette is inked come forward below the ink, by most at the outline,
/// where an upright wall with the paint beside the ink closes them: x and y, normals and texture
/// coordinates of all vertices stay, and a wall is not seen from the front. Beside other parts
/// nothing moves. Walls come first among the triangles of a part. Linear in pixels times parts
/// and in the vertices near silhouettes times those around each.
void narrow_inked_rims(Model& model, const Drawing& drawing);

}  // namespace relievo
