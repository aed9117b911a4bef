#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/join_proposals/join_proposals.h"

namespace relievo {

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

}  // namespace relievo
