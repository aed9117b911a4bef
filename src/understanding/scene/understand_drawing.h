#pragma once

#include <string>
#include <vector>

#include "understanding/labels/drawing_evidence.h"
#include "understanding/labels/segmentation.h"
#include "understanding/scene/propose_scene.h"
#include "understanding/scene/segmentation_record.h"

namespace relievo::understanding {

/// The understanding of a flat drawing, from its labels to the scene.
struct Understanding {
  Segmentation segmentation;  ///< numbered as the record; empty where the record gave the labels
  DrawingEvidence evidence;
  Proposal proposal;          ///< by labels and corrections
  SegmentationRecord record;  ///< the known one with the proposal in place of the earlier one
  /// The proposed scene with the user's edits (see keep_edits): valid, or without parts where all
  /// were removed.
  Scene scene;
  std::vector<std::string> warnings;  ///< one sentence each, of all steps
};

/// Understands a drawing, RGBA. `segmentation` gives its labels, which are renumbered as in `known`
/// (see relabel); an empty one leaves the labels of `known`. `edited` is the scene that was
/// proposed before with the user's edits since, without parts where there is none. Errors: those of
/// propose_scene, `bad_input` where an edit is not valid.
Result<Understanding> understand_drawing(const Image8& rgba, Segmentation segmentation,
                                         SegmentationRecord known, const Scene& edited = {},
                                         const RunContext& context = {});

}  // namespace relievo::understanding
