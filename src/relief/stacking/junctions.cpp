#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/base/exact_functions.h"
#include "relief/stacking/order_graph.h"

namespace relievo {
namespace {

constexpr double spread = std::numbers::pi / 6;
constexpr double min_junction_confidence = 0.01;
/// Sides beside a junction whose middles give the direction there, and how many next to it, which
/// the width of drawn lines displaces, do not.
constexpr int far_side = 14;
constexpr int near_side = 3;

/// Where the label across a ring changes: between side `at` - 1 and side `at`.
struct Change {
  size_t at = 0;
  int before = 0;  ///< sides with the label before the change, up to far_side
  int after = 0;
};

int run_length(const LabelRing& ring, size_t at, int step) {
  const size_t n = ring.size();
  int count = 0;
  while (count < far_side) {
    const size_t i = (at + 2 * n + static_cast<size_t>(step * count + static_cast<int>(n))) % n;
    if (ring.beyond[i] != ring.beyond[at]) break;
    ++count;
  }
  return count;
}

std::vector<Change> changes(const LabelRing& ring) {
  std::vector<Change> found;
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    const size_t previous = (i + n - 1) % n;
    if (ring.beyond[i] == ring.beyond[previous]) continue;
    const Change change{i, run_length(ring, previous, -1), run_length(ring, i, 1)};
    if (std::min(change.before, change.after) > near_side + 1) found.push_back(change);
  }
  return found;
}

/// How far the contour turns at the change, in [0, pi].
double turn(const LabelRing& ring, const Change& change) {
  const size_t n = ring.size();
  const auto side = [&](int offset) {
    return ring.sides[(change.at + n * 2 + static_cast<size_t>(offset + static_cast<int>(n))) % n];
  };
  const Point2 in = side(-near_side) - side(-change.before);
  const Point2 out = side(change.after - 1) - side(near_side);
  return std::abs(exact::angle_of(cross(in, out), dot(in, out)));
}

}  // namespace

std::vector<JunctionCue> find_junction_cues(const PartRegions& regions) {
  std::vector<JunctionCue> cues;
  for (int part = 0; part < regions.count(); ++part)
    for (const LabelRing& ring : regions.rings[part])
      for (const Change& change : changes(ring)) {
        const double confidence = exact::exp(-turn(ring, change) / (spread * spread));
        if (confidence < min_junction_confidence) continue;
        const size_t previous = (change.at + ring.size() - 1) % ring.size();
        for (const size_t i : {previous, change.at}) {
          const int lower = regions.part_of(ring.beyond[i]);
          if (lower >= 0) cues.push_back({part, lower, confidence});
        }
      }
  return cues;
}

}  // namespace relievo
