#pragma once

#include <vector>

#include "kernel/geometry/region.h"
#include "relievo/scene.h"

namespace relievo::understanding {

/// Shares out the ink that no part covers, as far as it is within `reach` of one: each point goes
/// to the part that is nearest, the frontmost of equals.
void cover_ink(std::vector<Part>& parts, const Region& ink, double reach);

/// Extends the parts so that together they cover `covered`. A piece that is left goes to the part
/// it touches most, the frontmost of equals; one that touches none becomes a part of its own if
/// it is worth it (1/500 of the whole), else another ring of the nearest part.
void cover_rest(std::vector<Part>& parts, const Region& covered);

}  // namespace relievo::understanding
