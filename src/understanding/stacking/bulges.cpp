#include "understanding/stacking/bulges.h"

#include <cmath>
#include <map>

#include "kernel/base/cyclic_runs.h"
#include "kernel/base/exact_functions.h"

namespace relievo::understanding {
namespace {

constexpr double bulge_scale = 0.06;
constexpr size_t min_sides = 8;

/// Sums over the runs of a common boundary.
struct Bulge {
  double area = 0;    ///< on the other part's side of the chords, px^2
  double chords = 0;  ///< squared lengths
};

/// Twice the area between a run of sides and its chord; positive where the ring's own part
/// bulges out.
double twice_area(const LabelRing& ring, size_t first, size_t count) {
  const Point2 origin = ring.sides[first % ring.size()];
  double sum = 0;
  for (size_t i = first; i + 1 < first + count; ++i)
    sum += cross(ring.sides[i % ring.size()] - origin, ring.sides[(i + 1) % ring.size()] - origin);
  return sum;
}

}  // namespace

std::vector<BulgeCue> find_bulge_cues(const PartRegions& regions) {
  std::map<std::pair<int, int>, Bulge> bulges;
  for (int part = 0; part < regions.count(); ++part)
    for (const LabelRing& ring : regions.rings[part]) {
      const auto same = [&](size_t i, size_t j) { return ring.beyond[i] == ring.beyond[j]; };
      for_each_run(ring.size(), same, [&](size_t first, size_t count) {
        const int other = regions.part_of(ring.beyond[first]);
        if (other < part || count < min_sides) return;
        const Point2 chord = ring.sides[(first + count - 1) % ring.size()] - ring.sides[first];
        Bulge& bulge = bulges[{part, other}];
        bulge.area += twice_area(ring, first, count) / 2;
        bulge.chords += dot(chord, chord);
      });
    }
  std::vector<BulgeCue> cues;
  for (const auto& [pair, bulge] : bulges) {
    if (bulge.area == 0) continue;
    const double confidence =
        1 - exact::exp(-std::abs(bulge.area) / (bulge_scale * std::max(bulge.chords, 1e-9)));
    const bool first = bulge.area > 0;
    cues.push_back(
        {first ? pair.first : pair.second, first ? pair.second : pair.first, confidence});
  }
  return cues;
}

}  // namespace relievo::understanding
