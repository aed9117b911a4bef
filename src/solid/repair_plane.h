#pragma once

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// Turns the triangles of a field counter-clockwise that rounding to the grid turned over or made
/// flat: drops them between their neighbours, or moves one of their points to the next. Where the
/// field touches itself in a point, moves the sides apart by up to `gap` grid steps. Fails with
/// internal where triangles remain that cannot be repaired. O(F) for every repair, of which there
/// are a few in 100,000 triangles.
Status repair_plane(double gap, HeightField& field);

}  // namespace relievo
