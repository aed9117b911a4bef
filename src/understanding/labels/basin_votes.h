#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "understanding/areas/basins.h"
#include "understanding/labels/mark_pixels.h"

namespace relievo::understanding {

/// What scribbles say in terms of basins. Label 0 is background, k + 1 is Scribbles::parts[k].
struct BasinVotes {
  struct HardPixel {
    int32_t pixel = 0;
    int basin = 0;
    int label = 0;
  };
  std::vector<HardPixel> hard;                  ///< sorted by basin, then pixel
  std::vector<std::map<int, int64_t>> soft;     ///< [#B] label -> px that vote for it
  std::vector<std::set<int>> labels_in_region;  ///< [#R + 1] labels that may be taken there
  std::vector<bool> is_hole;                    ///< [#R + 1] only hole strokes lie there
};

/// Counts the strokes. On lines they say nothing, since lines are shared. Of a hard stroke, what
/// slipped into a region with less than a tenth of its pixels, or with half of them out of the
/// figure, is dropped; background at the picture's edge counts as marked where strokes for parts
/// lie in it.
BasinVotes count_votes(const Basins& basins, const Scribbles& scribbles);

}  // namespace relievo::understanding
