#pragma once

#include <string>
#include <vector>

#include "relievo/image.h"
#include "understanding/completion/completion.h"
#include "understanding/labels/corrections.h"
#include "understanding/labels/scribbles.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// A part as it was proposed.
struct PartRecord {
  PartLabel label = 0;
  std::string id;
  CompletionKind completion = CompletionKind::whole;
};

/// A proposed join and its confidence; the scene has its line.
struct JoinRecord {
  PartLabel upper = 0;
  PartLabel lower = 0;
  double confidence = 0;
};

/// The understanding of a flat drawing as a project file keeps it, with the user's input.
struct SegmentationRecord {
  Image16 labels;  ///< the part of every pixel, 0 for the background; empty before the first one
  Scribbles scribbles;
  Corrections corrections;
  std::vector<PartRecord> parts;  ///< back to front
  std::vector<OrderArrow> order;
  std::vector<JoinRecord> joins;
};

}  // namespace relievo::understanding
