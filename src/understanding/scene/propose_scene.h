#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"
#include "understanding/completion/complete_parts.h"
#include "understanding/joins/propose_joins.h"
#include "understanding/scene/corrections.h"
#include "understanding/stacking/stack_parts.h"

namespace relievo::understanding {

struct ProposalOptions {
  CompletionOptions completion;
  JoinProposalOptions joining;
  int max_parts = 1024;
  double rim = 0;       ///< px of outer ink that parts hold towards the background, see rim_width
  int min_pixels = 16;  ///< labels with fewer pixels are left out, with a warning
};

/// What was understood of a segmented drawing, and the scene that it makes.
struct Proposal {
  PartRegions regions;
  std::vector<NeighbourEvidence> evidence;
  Completion completion;  ///< shapes as they are if nothing is cut off by the order
  Stacking stacking;
  JoinProposals joining;
  Scene scene;  ///< without a drawing; part k is the part stacking.back_to_front[k]
  std::vector<std::string> warnings;
};

/// From labels (a pixel's part, 0 for the background) to a scene: completion, order, joins and
/// relations. Errors: `bad_input` where there are no parts or a correction names one that is not
/// there, `limit` where there are too many, `contradiction` where arrows of the user form a
/// circle, `interrupted`. Near-linear in pixels, times the number of parts that overlap.
Result<Proposal> propose_scene(const Image16& labels, const Corrections& corrections = {},
                               const ProposalOptions& options = {}, const RunContext& context = {});

}  // namespace relievo::understanding
