#include "understanding/stacking/junctions.h"

#include "kernel/image/outlines.h"

namespace relievo::understanding {
namespace {

constexpr double least_confidence = 0.01;  ///< cues below are left out

}  // namespace

std::vector<JunctionCue> find_junction_cues(const PartRegions& regions) {
  std::vector<JunctionCue> cues;
  for (int part = 0; part < regions.count(); ++part)
    for (const LabelRing& ring : regions.rings[part])
      for (const Junction& junction : find_junctions(ring)) {
        const double confidence = t_junction_confidence(junction);
        if (confidence < least_confidence) continue;
        for (const uint16_t beyond : {junction.before, junction.after}) {
          const int lower = regions.part_of(beyond);
          if (lower >= 0) cues.push_back({part, lower, confidence});
        }
      }
  return cues;
}

}  // namespace relievo::understanding
