#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"
#include "understanding/completion/completion.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/labels/scribbles.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// A part's value in the label image.
using PartLabel = uint16_t;

/// What the user says of a part. Whatever is absent is proposed.
struct PartCorrection {
  std::optional<std::string> id;
  std::optional<Outline> outline;  ///< the completed part, canvas px
  std::optional<double> c;
  std::optional<double> d;
  std::optional<double> flat;
  std::optional<Point2> lean;
};

/// Everything that the user says about a segmented drawing; never overruled. Parts are named by
/// their labels, also where `joining` and `cues` have indices.
struct Corrections {
  std::map<PartLabel, PartCorrection> parts;
  std::vector<std::pair<PartLabel, PartLabel>> order;  ///< the first is in front of the second
  JoinCorrections joining;
  std::vector<Cue> cues;
};

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

}  // namespace relievo::understanding
