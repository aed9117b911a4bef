#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// Corrections of one part. Absent values are proposed.
struct PartCorrection {
  std::optional<std::string> id;
  std::optional<Outline> outline;  ///< the completed part, canvas px
  std::optional<double> c;
  std::optional<double> d;
  std::optional<double> flat;
  std::optional<Point2> lean;
};

/// Everything that the user says about the parts of a segmented drawing. Parts are named by their
/// labels throughout, so `upper`, `lower` and `part` of the scene's types are labels here, not
/// indices. A correction is never overruled; one of a pair of parts replaces all proposals for that
/// pair.
struct Corrections {
  std::map<PartLabel, PartCorrection> parts;
  std::vector<std::pair<PartLabel, PartLabel>> order;  ///< the first is in front of the second
  std::vector<Join> joins;
  std::vector<std::pair<PartLabel, PartLabel>> no_joins;  ///< upper, lower
  std::vector<Relation> relations;
  std::vector<RobinRange> robin;
  std::vector<Cue> cues;
};

}  // namespace relievo::understanding
