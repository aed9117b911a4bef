#pragma once

#include <vector>

#include "relief/inflation/inflation.h"
#include "relief/model/cut_faces.h"
#include "relief/model/visible_sheet.h"
#include "relief/ordering/ordering.h"

namespace relievo {

/// What lies behind the vertices of a cut surface, its cuts included, all sheets counted but
/// hollows: of the part with the least g - |f|, the first of several.
/// O(faces + cuts * height of a stack).
std::vector<BackPoint> back_points(const CutSurface& surface, const Inflation& inflation,
                                   const Ordering& ordering);

}  // namespace relievo
