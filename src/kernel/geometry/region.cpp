#include "kernel/geometry/region.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/geometry/clipper_paths.h"

namespace relievo {
using ClipperLib::Paths;

Region unite(const Region& p, const Region& q) {
  return to_region(combine(ClipperLib::ctUnion, to_paths(p), to_paths(q)));
}

Region unite(const std::vector<Region>& regions) {
  // Rounds of pairs: rings inside others drop out early.
  std::vector<Paths> round;
  for (const Region& region : regions) round.push_back(to_paths(region));
  while (round.size() > 1) {
    for (size_t i = 0; 2 * i < round.size(); ++i) {
      const Paths second = 2 * i + 1 < round.size() ? round[2 * i + 1] : Paths();
      round[i] = combine(ClipperLib::ctUnion, round[2 * i], second);
    }
    round.resize((round.size() + 1) / 2);
  }
  return round.empty() ? Region() : to_region(combine(ClipperLib::ctUnion, round[0], {}));
}

Region intersect(const Region& p, const Region& q) {
  if (p.empty() || q.empty()) return {};
  return to_region(combine(ClipperLib::ctIntersection, to_paths(p), to_paths(q)));
}

Region subtract(const Region& p, const Region& q) {
  if (p.empty()) return {};
  return to_region(combine(ClipperLib::ctDifference, to_paths(p), to_paths(q)));
}

Region grow(const Region& region, double distance) {
  return to_region(
      grow_paths(to_paths(region), distance * clipper_units_per_px, clipper_arc_tolerance));
}

bool boxes_meet(const Box2& p, const Box2& q) {
  return p.min.x <= q.max.x && q.min.x <= p.max.x && p.min.y <= q.max.y && q.min.y <= p.max.y;
}

std::vector<Region> pieces(const Region& region) {
  std::vector<Region> result;
  for (const Paths& paths : pieces_of(ClipperLib::ctUnion, to_paths(region), {}))
    result.push_back(to_region(paths));
  std::stable_sort(result.begin(), result.end(),
                   [](const Region& p, const Region& q) { return area(p) > area(q); });
  return result;
}

Region without_holes(const Region& region) {
  Region outer;
  for (const Ring& ring : region) {
    if (signed_area(ring) > 0) outer.push_back(ring);
  }
  return unite({outer});
}

Region tidied(const Region& region, double tolerance, double min_area) {
  Paths paths = to_paths(region);
  ClipperLib::CleanPolygons(paths, tolerance * clipper_units_per_px);
  const Region clean =
      to_region(combine(ClipperLib::ctUnion, paths, {}, ClipperLib::pftNonZero, true));
  Region kept;
  for (const Ring& ring : clean) {
    if (std::abs(signed_area(ring)) >= min_area) kept.push_back(ring);
  }
  return kept;
}

}  // namespace relievo
