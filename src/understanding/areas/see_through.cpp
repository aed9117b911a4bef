#include "understanding/areas/see_through.h"

#include <array>
#include <map>
#include <optional>

#include "kernel/base/cyclic_runs.h"
#include "kernel/image/outlines.h"

namespace relievo::understanding {
namespace {

/// Around a crossing, outlines are looked at between these distances from it: widths of a line, and
/// so many px more.
constexpr double nearest_widths = 1.5;
constexpr double crossing_reach = 14;
constexpr double straight_cosine = 0.77;  ///< of 40 degrees, by which they turn at most
constexpr double crossing_cosine = 0.94;  ///< of 20 degrees, by which they differ at least
constexpr size_t least_sides = 4;         ///< of an outline there

/// Per label, its rings' sides by the label beyond.
using SidesBetween = std::map<uint16_t, std::map<uint16_t, std::vector<Point2>>>;

/// A piece of an area's ring along one neighbour.
struct Run {
  uint16_t beyond = 0;
  size_t first = 0;
  size_t count = 0;
};

std::vector<Run> long_runs(const LabelRing& ring, double line_width) {
  std::vector<Run> runs;
  const auto same = [&](size_t i, size_t j) { return ring.beyond[i] == ring.beyond[j]; };
  for_each_run(ring.size(), same, [&](size_t first, size_t count) {
    if (static_cast<double>(count) > 2 * line_width)
      runs.push_back({ring.beyond[first], first, count});
  });
  return runs;
}

/// An area that has one run with either of two others, and where these meet.
struct Candidate {
  SharedArea overlap;
  std::array<Point2, 2> ends;
};

std::vector<Candidate> find_candidates(const std::vector<LabelRing>& rings, double line_width) {
  std::vector<Candidate> candidates;
  for (const LabelRing& ring : rings) {
    if (ring.hole) continue;
    const std::vector<Run> runs = long_runs(ring, line_width);
    if (runs.size() != 2 || runs[0].beyond == runs[1].beyond) continue;
    if (runs[0].beyond == 0 || runs[1].beyond == 0) continue;
    const auto end_of = [&](const Run& run, const Run& next) {
      const Point2 last = ring.sides[(run.first + run.count - 1) % ring.size()];
      return 0.5 * (last + ring.sides[next.first]);
    };
    candidates.push_back({{ring.label, runs[0].beyond, runs[1].beyond},
                          {end_of(runs[0], runs[1]), end_of(runs[1], runs[0])}});
  }
  return candidates;
}

class Crossings {
 public:
  Crossings(const std::vector<LabelRing>& rings, double line_width)
      : nearest_(nearest_widths * line_width + 2) {
    for (const LabelRing& ring : rings) {
      const auto same = [&](size_t i, size_t j) { return ring.beyond[i] == ring.beyond[j]; };
      for_each_run(ring.size(), same, [&](size_t first, size_t count) {
        std::vector<Point2>& sides = between_[ring.label][ring.beyond[first]];
        for (size_t i = first; i < first + count; ++i) sides.push_back(ring.sides[i % ring.size()]);
      });
    }
  }

  /// Whether the outlines of a and b, whose common area is `shared`, go straight on where they
  /// meet: that of a on one side of the crossing between the area and b, on the other between a
  /// and something else.
  bool is_at(Point2 at, const SharedArea& overlap) const {
    const auto own_a = direction(at, overlap.shared, overlap.b);
    const auto own_b = direction(at, overlap.shared, overlap.a);
    if (!own_a || !own_b || dot(*own_a, *own_b) > crossing_cosine) return false;
    const auto goes_on = [&](uint16_t part, uint16_t other, Point2 from) {
      for (const auto& [beyond, sides] : between_.at(part)) {
        if (beyond == overlap.shared || beyond == other) continue;
        const auto way = direction(at, part, beyond);
        if (way && dot(*way, from) < -straight_cosine) return true;
      }
      return false;
    };
    return goes_on(overlap.a, overlap.b, *own_a) && goes_on(overlap.b, overlap.a, *own_b);
  }

 private:
  /// The mean direction from a point to the sides between two labels around it.
  std::optional<Point2> direction(Point2 at, uint16_t label, uint16_t beyond) const {
    Point2 sum;
    size_t count = 0;
    for (const Point2 side : between_.at(label).at(beyond)) {
      const double away = distance(side, at);
      if (away < nearest_ || away > nearest_ + crossing_reach) continue;
      sum = sum + 1 / away * (side - at);
      ++count;
    }
    const double length = norm(sum);
    if (count < least_sides || length < 0.5 * static_cast<double>(count)) return std::nullopt;
    return 1 / length * sum;
  }

  double nearest_;
  SidesBetween between_;
};

}  // namespace

std::vector<SharedArea> find_shared_areas(const Image16& labels, double line_width) {
  const std::vector<LabelRing> rings = trace_label_rings(labels);
  const std::vector<Candidate> candidates = find_candidates(rings, line_width);
  if (candidates.empty()) return {};
  const Crossings crossings(rings, line_width);
  std::vector<SharedArea> overlaps;
  for (const Candidate& candidate : candidates)
    if (crossings.is_at(candidate.ends[0], candidate.overlap) &&
        crossings.is_at(candidate.ends[1], candidate.overlap))
      overlaps.push_back(candidate.overlap);
  return overlaps;
}

}  // namespace relievo::understanding
