#pragma once

#include "relievo/scene.h"
#include "understanding/scene/segmentation_record.h"

namespace relievo::understanding {

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
