#pragma once

#include <string>
#include <vector>

#include "relievo/run_context.h"
#include "relievo/scene.h"
#include "understanding/completion/complete_parts.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/labels/corrections.h"
#include "understanding/labels/drawing_evidence.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// The proposed scene of a segmented drawing, and how it was found. Indices are those of the
/// scene's parts, which are sorted back to front: scene.parts[k] has the label regions.labels[k].
struct Proposal {
  PartRegions regions;
  std::vector<NeighbourEvidence> evidence;
  Completion completion;  ///< shapes before the order cuts anything off
  std::vector<OrderArrow> order;
  JoinProposals joining;
  Scene scene;  ///< without a drawing
  std::vector<std::string> warnings;
};

/// Makes a scene of labels (a pixel's part, 0 for the background): completion, order, joins and
/// relations. Errors: `bad_input` where there are no parts or a correction names one that is not
/// there, `limit` above 1024 parts, `contradiction` where arrows of the user form a circle,
/// `interrupted`. Near-linear in pixels, times the number of parts that overlap.
Result<Proposal> propose_scene(const Image16& labels, const Corrections& corrections = {},
                               const DrawingEvidence& drawing = {}, const RunContext& context = {});

}  // namespace relievo::understanding
