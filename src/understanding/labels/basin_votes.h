#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "understanding/areas/basins.h"
#include "understanding/labels/stroke_pixels.h"

namespace relievo::understanding {

/// The strokes' votes on basins. Label 0 is background, k + 1 is Scribbles::parts[k].
struct BasinVotes {
  /// A pixel under a hard stroke.
  struct HardPixel {
    int32_t pixel = 0;  ///< y * width + x
    int basin = 0;
    int label = 0;
  };
  std::vector<HardPixel> hard;                  ///< sorted by basin, then pixel
  std::vector<std::map<int, int64_t>> soft;     ///< [#B] by label, px that vote for it
  std::vector<std::set<int>> labels_in_region;  ///< [#R + 1] labels of the strokes that lie there
};

/// Counts the votes of the marked pixels. Pixels on lines do not vote, since lines are shared,
/// unless the whole stroke lies on lines. Strokes along lines do not vote on the background beside
/// them. The pixels of a hard stroke in a region count as a slip and are dropped where they are
/// less than a tenth of it, or less than half of it on the background. Where a hard stroke of a
/// part lies in background at the picture's border, that border is marked as background.
BasinVotes count_votes(const Basins& basins, const Scribbles& scribbles,
                       std::vector<StrokePixel> marks);

}  // namespace relievo::understanding
