#include "understanding/stacking/bulges.h"

#include <cmath>
#include <map>

#include "kernel/base/cyclic_runs.h"
#include "kernel/base/exact_functions.h"

namespace relievo::understanding {
namespace {

constexpr double bulge_scale = 0.06;  ///< A / C at which the confidence is 1 - 1/e
constexpr size_t min_sides = 8;       ///< shorter runs of a boundary are ignored

/// Sums over the runs of a common boundary.
struct Bulge {
  double area = 0;    ///< A: on the second part's side of the chords, px^2
  double chords = 0;  ///< C: squared lengths, px^2
};

/// Twice the area between a run of sides and its chord; positive where the ring's own part bulges
/// out.
double twice_area(const LabelRing& ring, size_t first, size_t count) {
  const Point2 origin = ring.sides[first % ring.size()];
  double sum = 0;
  for (size_t i = first; i + 1 < first + count; ++i)
    sum += cross(ring.sides[i % ring.size()] - origin, ring.sides[(i + 1) % ring.size()] - origin);
  return sum;
}

}  // namespace

std::vector<OrderArrow> find_bulges(const PartRegions& regions) {
  std::map<std::pair<PartLabel, PartLabel>, Bulge> bulges;
  for (const std::vector<LabelRing>& rings : regions.rings)
    for (const LabelRing& ring : rings) {
      const auto same = [&](size_t i, size_t j) { return ring.beyond[i] == ring.beyond[j]; };
      for_each_run(ring.size(), same, [&](size_t first, size_t count) {
        const PartLabel other = ring.beyond[first];
        if (other < ring.label || count < min_sides) return;
        const Point2 chord = ring.sides[(first + count - 1) % ring.size()] - ring.sides[first];
        Bulge& bulge = bulges[{ring.label, other}];
        bulge.area += twice_area(ring, first, count) / 2;
        bulge.chords += dot(chord, chord);
      });
    }
  std::vector<OrderArrow> arrows;
  for (const auto& [pair, bulge] : bulges) {
    if (bulge.area == 0) continue;
    const double confidence =
        1 - exact::exp(-std::abs(bulge.area) / (bulge_scale * std::max(bulge.chords, 1e-9)));
    const auto [first, second] = pair;
    if (bulge.area > 0)
      arrows.push_back({first, second, confidence});
    else
      arrows.push_back({second, first, confidence});
  }
  return arrows;
}

}  // namespace relievo::understanding
