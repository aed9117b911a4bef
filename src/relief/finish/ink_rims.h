#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Keeps the ink of outlines a thin line when the model is turned. Surfaces stand upright at their
/// outlines, so that ink w px wide on a ball of radius R reaches sqrt(2 R w) deep, a broad dark
/// band. A part at least half of whose seen outline is inked is made to begin where its ink ends:
/// under the ink it is lowered to the height of the outline, or to just above the parts below it,
/// and within a few widths of the ink it rounds off to that. Parts that end on a lowered part
/// follow it. Vertices that parts share, at joins, stay, and nothing next to them is lowered. Only
/// z decreases; x and y, normals and texture coordinates stay. Linear in pixels and in the vertices
/// near outlines times those around each.
void narrow_inked_rims(Model& model, const Drawing& drawing);

}  // namespace relievo::relief
