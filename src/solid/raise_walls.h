#pragma once

#include "relievo/model.h"
#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// The solid below a field: its triangles, upright walls where it has steps and along its rim, and
/// a flat back at z = 0. In mm: X right, Y up, Z to the viewer, its box's corner in the origin.
/// `parts`: names and values for `triangle_part`; walls belong to the higher side's part, the back
/// to the last part. `back_uv`: where the back lies on the drawing. Precondition: the field's
/// triangles face the viewer and settle_heights has run. Every edge of the result has exactly two
/// triangles after vertices at one place are merged. O(F log F).
Result<Model> raise_walls(const HeightField& field, const FieldEdges& edges,
                          const std::vector<ModelPart>& parts, Point2 back_uv);

}  // namespace relievo
