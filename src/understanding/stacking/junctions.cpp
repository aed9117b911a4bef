#include "understanding/stacking/junctions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/base/exact_functions.h"
#include "kernel/geometry/polyline.h"
#include "kernel/image/ring_changes.h"

namespace relievo::understanding {
namespace {

constexpr double spread = std::numbers::pi / 6;
constexpr double min_junction_confidence = 0.01;
/// Sides beside a junction whose middles give the direction there, and how many next to it, which
/// the width of drawn lines displaces, do not.
constexpr size_t far_side = 14;
constexpr size_t near_side = 3;

}  // namespace

std::vector<JunctionCue> find_junction_cues(const PartRegions& regions) {
  std::vector<JunctionCue> cues;
  for (int part = 0; part < regions.count(); ++part)
    for (const LabelRing& ring : regions.rings[part])
      for (const RingChange& change : ring_changes(ring, near_side, far_side)) {
        if (std::min(change.run_before, change.run_after) <= near_side + 1) continue;
        const double turn = std::abs(turn_between(change.in, change.out));
        const double confidence = exact::exp(-turn / (spread * spread));
        if (confidence < min_junction_confidence) continue;
        for (const uint16_t beyond : {change.before, change.after}) {
          const int lower = regions.part_of(beyond);
          if (lower >= 0) cues.push_back({part, lower, confidence});
        }
      }
  return cues;
}

}  // namespace relievo::understanding
