#pragma once

#include <vector>

#include "understanding/labels/segmentation.h"
#include "understanding/scene/corrections.h"
#include "understanding/scene/propose_scene.h"

namespace relievo::understanding {

/// A record with new labels.
struct Relabelling {
  SegmentationRecord record;
  std::vector<PartLabel> label_of;  ///< [parts of the segmentation] in the record's labels
};

/// Takes a new segmentation over into a record: its parts are numbered as they were before (see
/// keep_labels), those with strokes are called by their ids, and corrections of what is gone, or
/// has fewer pixels than `options` want, are dropped. Linear in pixels.
Relabelling relabel(const Segmentation& found, SegmentationRecord known,
                    const ProposalOptions& options = {});

/// What labels, corrections and edits make of a flat drawing.
struct Understanding {
  Proposal proposal;          ///< that of labels and corrections
  SegmentationRecord record;  ///< the known one with what is proposed now
  /// The proposed scene with the user's edits (see keep_edits). It has no parts where all were
  /// removed, and is valid otherwise.
  Scene scene;
};

/// Understands a drawing, RGBA, whose labels are those of `known`, anew. `edited` is the scene that
/// was made of it before and what the user has done to it since; without parts where there is
/// none. Errors: those of propose_scene, `bad_input` where an edit is not valid.
Result<Understanding> understand_drawing(const Image8& rgba, const SegmentationRecord& known,
                                         const Scene& edited, const ProposalOptions& options = {},
                                         const RunContext& context = {});

}  // namespace relievo::understanding
