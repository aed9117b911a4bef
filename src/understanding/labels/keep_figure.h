#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"
#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Lets nothing of the figure be lost: pixels of it that have no label take the nearest one, or
/// where there is none a new one after `last_label`. Areas that strokes made background stay it.
/// `labels` has those of all pixels, `of_basin` those of basins. O(pixels).
void keep_figure(const Basins& basins, const std::vector<int>& of_basin, int last_label,
                 Image<int32_t>& labels);

}  // namespace relievo::understanding
