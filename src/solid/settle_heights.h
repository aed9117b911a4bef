#pragma once

#include "solid/height_field.h"

namespace relievo {

/// Raises heights as needed for the surface of the solid below the field to be a manifold: along no
/// edge do the two sides change order, and around every point heights rise to one highest side and
/// fall again, so that two walls meet along every upright line. Outside the field the height is 0.
/// Near-linear; in practice a few points change.
void settle_heights(const FieldEdges& edges, HeightField& field);

}  // namespace relievo
