#pragma once

#include "relievo/scene.h"
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

/// Renames proposed parts that have the id of a part that the user drew. `known` is the record of
/// the proposal that was edited: parts of `edited` that are not in it were drawn by hand.
void avoid_drawn_names(const Scene& edited, const SegmentationRecord& known, Scene& proposed);

/// Applies the edits of an earlier proposal to a new one. Parts that the user removed stay away
/// unless they have strokes. Parts that the user drew stay between the parts between which they
/// lay, with their connections; a connection of two parts that have changed places is dropped.
/// `known` is the record of the proposal that was edited, `labels` are those of the proposed parts.
/// O(parts^2 + connections).
Scene keep_edits(const Scene& proposed, const std::vector<PartLabel>& labels, const Scene& edited,
                 const SegmentationRecord& known);

}  // namespace relievo::understanding
