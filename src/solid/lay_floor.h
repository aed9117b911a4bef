#pragma once

#include <cstdint>

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// What a floor may be, in grid steps.
struct FloorLimits {
  int64_t least = 1;  ///< below the field
  int64_t soft = 0;   ///< width of steps in it, about
};

/// Counts the heights of a field from its floor. Steps in the floor become ramps, but at the rim,
/// and where the field comes too near it is lowered, and around there so that no spikes stand out.
/// Fails with internal where that cannot be computed. Near-linear.
Status lay_floor(const FloorLimits& limits, const FieldEdges& edges, HeightField& field);

}  // namespace relievo
