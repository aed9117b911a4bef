#include "understanding/areas/see_through.h"

#include <map>
#include <optional>

#include "kernel/base/cyclic_runs.h"
#include "kernel/image/outlines.h"

namespace relievo::understanding {
namespace {

constexpr double nearest_widths = 1.5;    ///< line widths at a crossing where outlines are blurred
constexpr double crossing_reach = 14;     ///< px beyond these where outlines are looked at
constexpr double straight_cosine = 0.77;  ///< of 40 degrees, the largest turn of a straight outline
constexpr double crossing_cosine = 0.94;  ///< of 20 degrees, the least angle between two outlines
constexpr size_t least_sides = 4;         ///< least number of an outline's pixel sides there

/// By label and the label beyond, the middles of the pixel sides between them.
using SidesBetween = std::map<uint16_t, std::map<uint16_t, std::vector<Point2>>>;

/// A piece of an area's ring along one neighbour.
struct Run {
  uint16_t beyond = 0;  ///< label of the neighbour
  size_t first = 0;     ///< index of a side
  size_t count = 0;
};

std::vector<Run> runs_of(const LabelRing& ring) {
  std::vector<Run> runs;
  const auto same = [&](size_t i, size_t j) { return ring.beyond[i] == ring.beyond[j]; };
  for_each_run(ring.size(), same, [&](size_t first, size_t count) {
    runs.push_back({ring.beyond[first], first, count});
  });
  return runs;
}

SidesBetween collect_sides(const std::vector<LabelRing>& rings) {
  SidesBetween between;
  for (const LabelRing& ring : rings)
    for (const Run& run : runs_of(ring)) {
      std::vector<Point2>& sides = between[ring.label][run.beyond];
      for (size_t i = run.first; i < run.first + run.count; ++i)
        sides.push_back(ring.sides[i % ring.size()]);
    }
  return between;
}

/// Computes the mean direction from a point to the sides at `nearest` to `nearest + crossing_reach`
/// px from it; nothing where they are few or have no common direction.
std::optional<Point2> direction(const std::vector<Point2>& sides, Point2 at, double nearest) {
  Point2 sum;
  size_t count = 0;
  for (const Point2 side : sides) {
    const double away = distance(side, at);
    if (away < nearest || away > nearest + crossing_reach) continue;
    sum = sum + 1 / away * (side - at);
    ++count;
  }
  const double length = norm(sum);
  if (count < least_sides || length < 0.5 * static_cast<double>(count)) return std::nullopt;
  return 1 / length * sum;
}

/// Returns whether the outlines of parts a and b cross at a point: on one side of it the outline of
/// a separates the shared area and b, and it runs straight on between a and a third label; likewise
/// that of b.
bool cross_at(Point2 at, const SharedArea& area, const SidesBetween& between, double nearest) {
  const auto own_a = direction(between.at(area.shared).at(area.b), at, nearest);
  const auto own_b = direction(between.at(area.shared).at(area.a), at, nearest);
  if (!own_a || !own_b || dot(*own_a, *own_b) > crossing_cosine) return false;
  const auto goes_on = [&](uint16_t part, uint16_t other, Point2 from) {
    for (const auto& [beyond, sides] : between.at(part)) {
      if (beyond == area.shared || beyond == other) continue;
      const auto way = direction(sides, at, nearest);
      if (way && dot(*way, from) < -straight_cosine) return true;
    }
    return false;
  };
  return goes_on(area.a, area.b, *own_a) && goes_on(area.b, area.a, *own_b);
}

}  // namespace

std::vector<SharedArea> find_shared_areas(const Image16& labels, double line_width) {
  const std::vector<LabelRing> rings = trace_label_rings(labels);
  const double nearest = nearest_widths * line_width + 2;
  SidesBetween between;
  std::vector<SharedArea> found;
  for (const LabelRing& ring : rings) {
    if (ring.hole) continue;
    std::vector<Run> runs = runs_of(ring);
    std::erase_if(runs, [line_width](const Run& run) {
      return static_cast<double>(run.count) <= 2 * line_width;
    });
    if (runs.size() != 2 || runs[0].beyond == runs[1].beyond) continue;
    if (runs[0].beyond == 0 || runs[1].beyond == 0) continue;
    const SharedArea area = {ring.label, runs[0].beyond, runs[1].beyond};
    const auto end_of = [&](const Run& run, const Run& next) {
      const Point2 last = ring.sides[(run.first + run.count - 1) % ring.size()];
      return 0.5 * (last + ring.sides[next.first]);
    };
    if (between.empty()) between = collect_sides(rings);
    if (cross_at(end_of(runs[0], runs[1]), area, between, nearest) &&
        cross_at(end_of(runs[1], runs[0]), area, between, nearest))
      found.push_back(area);
  }
  return found;
}

}  // namespace relievo::understanding
