#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Keeps the ink of outlines a thin line when the model is turned. Surfaces stand upright at their
/// outlines, so that ink as wide as w px there reaches sqrt(2 R w) deep, a broad dark band. Parts
/// most of whose seen outline is inked, towards paper or what lies behind, begin where the ink
/// ends: below it they go back to the height of the outline, or to just above what lies behind
/// them, and within a few widths of the ink they round off to that. Joins, the vertices that parts
/// share, stay where they are, and nothing gives way next to them. Vertices move back alone: x and
/// y, normals and texture coordinates stay. Linear in pixels and in the vertices near outlines
/// times those around each.
void narrow_inked_rims(Model& model, const Drawing& drawing);

}  // namespace relievo::relief
