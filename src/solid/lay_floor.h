#pragma once

#include <cstdint>

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// Counts the heights of a field from its floor. First the floor's steps become ramps about `soft`
/// grid steps wide, except at the rim, and the floor is lowered to at least `least` grid steps
/// below the field, with slopes around so that no spikes stand out. Fails with internal if that
/// cannot be computed. Near-linear.
Status lay_floor(int64_t least, int64_t soft, const FieldEdges& edges, HeightField& field);

}  // namespace relievo
