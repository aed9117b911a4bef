#pragma once

#include <vector>

#include "relievo/scene.h"

namespace relievo {

/// Gives every part an id of its own: a part without one becomes "part-<place>", counted from 1 at
/// the back, and an id that an earlier part has gets a number ("arm-2"). O(parts log parts).
void make_ids_unique(std::vector<Part>& parts);

}  // namespace relievo
