#pragma once

#include "understanding/labels/segmentation.h"
#include "understanding/scene/segmentation_record.h"

namespace relievo::understanding {

/// Parts with fewer pixels are left out of scenes.
constexpr int least_part_pixels = 16;

/// Takes a new segmentation over into a record. Its parts are renumbered as they were before, so
/// that corrections stay with them: a part with strokes gets the label of its id, a proposed one
/// the label of the known part with which it shares most pixels, and all others new labels above
/// the known ones. Parts with strokes are called by their ids, and corrections of parts that are
/// gone, or that have too few pixels, are dropped. Linear in pixels.
void relabel(Segmentation& found, SegmentationRecord& record);

}  // namespace relievo::understanding
