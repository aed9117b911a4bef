#pragma once

#include <vector>

#include "relievo/model.h"
#include "relievo/result.h"
#include "solid/back_paint.h"
#include "solid/height_field.h"

namespace relievo {

/// Builds the solid between a field and its floor: the field's triangles, upright walls at its
/// steps and along its rim, and a back. In mm: X right, Y up, Z towards the viewer, the corner of
/// its box at the origin. `parts`: names and values for `triangle_part`; walls belong to the higher
/// side's part, a flat back to the last part. Precondition: the field's triangles face the viewer,
/// heights above a floor are positive, and settle_heights has run. Every edge of the result has
/// exactly two triangles after vertices at one position are merged. O(F log F).
Result<Model> raise_walls(const HeightField& field, const FieldEdges& edges,
                          const std::vector<ModelPart>& parts, const BackPaint& paint);

}  // namespace relievo
