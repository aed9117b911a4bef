#pragma once

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// Repairs the triangles of a field that rounding to the grid turned over or made flat: removes
/// them between their neighbours, or moves one of their points to the next. At points where the
/// field touches itself, moves the sides apart by up to `gap` grid steps. Fails with internal if
/// triangles remain that cannot be repaired. O(F) for every repair, of which there are a few in
/// 100,000 triangles.
Status repair_plane(double gap, HeightField& field);

}  // namespace relievo
