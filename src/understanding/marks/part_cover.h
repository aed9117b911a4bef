#pragma once

#include <vector>

#include "kernel/geometry/region.h"
#include "relievo/scene.h"

namespace relievo::understanding {

/// Shares out the ink that no part covers and that is within `reach` of a part: each point goes to
/// the nearest part, the frontmost of equals.
void cover_ink(std::vector<Part>& parts, const Region& ink, double reach);

/// Extends the parts so that together they cover `covered`. A remaining piece goes to the part that
/// it touches most, the frontmost of equals. A piece that touches no part becomes a part of its own
/// if it is larger than 1/500 of the whole, else another ring of the nearest part.
void cover_rest(std::vector<Part>& parts, const Region& covered);

}  // namespace relievo::understanding
