#pragma once

#include "solid/height_field.h"

namespace relievo {

/// Raises heights, where that is needed, so that the surface of the solid below the field is a
/// manifold: along no edge do the two sides change places, and around every point heights rise to
/// one highest side and fall again, so that two walls meet along every upright line. What lies
/// outside of the field counts as 0. Near-linear; a few points change in practice.
void settle_heights(const FieldEdges& edges, HeightField& field);

}  // namespace relievo
