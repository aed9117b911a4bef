#pragma once

#include <string>
#include <vector>

#include "relief/completion/completion.h"
#include "relief/corrections/corrections.h"
#include "relief/drawing/scribbles.h"
#include "relief/stacking/stacking.h"
#include "relievo/image.h"

namespace relievo {

/// How a part came to be.
struct PartRecord {
  PartLabel label = 0;
  std::string id;
  CompletionKind completion = CompletionKind::whole;
};

/// A join and how sure it is; its line is in the scene.
struct JoinRecord {
  PartLabel upper = 0;
  PartLabel lower = 0;
  double confidence = 0;
};

/// How a flat drawing was understood, and what the user said about it.
struct SegmentationRecord {
  Image16 labels;  ///< a pixel's part, 0 is background; empty where nothing is known yet
  Scribbles scribbles;
  Corrections corrections;
  std::vector<PartRecord> parts;  ///< back to front
  std::vector<OrderArrow> order;  ///< between labels
  std::vector<JoinRecord> joins;
};

}  // namespace relievo
