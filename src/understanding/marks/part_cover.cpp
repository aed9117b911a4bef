#include "understanding/marks/part_cover.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/region.h"

namespace relievo::understanding {
namespace {

constexpr double touching = 1;  ///< px
constexpr int ink_rounds = 4;   ///< of sharing out ink

double gap(const Box2& p, const Box2& q) {
  const double dx = std::max({0.0, p.min.x - q.max.x, q.min.x - p.max.x});
  const double dy = std::max({0.0, p.min.y - q.max.y, q.min.y - p.max.y});
  return std::hypot(dx, dy);
}

/// Returns the part with the largest common area with the piece's surroundings, or -1.
int touched_part(const std::vector<Part>& parts, const Region& surroundings) {
  int best = -1;
  double most = 0;
  for (size_t k = 0; k < parts.size(); ++k) {
    if (gap(bounding_box(parts[k].outline), bounding_box(surroundings)) > 0) continue;
    const double common = area(intersect(parts[k].outline, surroundings));
    if (common == 0 || common < most) continue;
    most = common;
    best = static_cast<int>(k);
  }
  return best;
}

int nearest_part(const std::vector<Part>& parts, const Region& piece) {
  const Box2 box = bounding_box(piece);
  int best = -1;
  for (size_t k = 0; k < parts.size(); ++k) {
    const double distance = gap(bounding_box(parts[k].outline), box);
    if (best < 0 || distance <= gap(bounding_box(parts[best].outline), box)) {
      best = static_cast<int>(k);
    }
  }
  return best;
}

}  // namespace

void cover_ink(std::vector<Part>& parts, const Region& ink, double reach) {
  std::vector<Region> outlines;
  for (const Part& part : parts) outlines.push_back(part.outline);
  Region left = subtract(ink, unite(outlines));
  for (int round = 0; round < ink_rounds && !left.empty(); ++round)
    for (size_t k = parts.size(); k-- > 0 && !left.empty();) {
      Outline& outline = parts[k].outline;
      if (gap(bounding_box(outline), bounding_box(left)) > reach) continue;
      const Region won = intersect(grow(outline, reach / ink_rounds), left);
      if (won.empty()) continue;
      outline = unite(outline, won);
      left = subtract(left, won);
    }
}

void cover_rest(std::vector<Part>& parts, const Region& covered) {
  std::vector<Region> outlines;
  for (const Part& part : parts) outlines.push_back(part.outline);
  const double total = area(covered);
  for (const Region& piece : pieces(subtract(covered, unite(outlines)))) {
    const Region near = intersect(grow(piece, touching), covered);
    if (near.empty()) continue;
    int host = touched_part(parts, near);
    if (host < 0 && (parts.empty() || area(piece) > 0.002 * total)) {
      parts.push_back({"", piece});
      continue;
    }
    if (host < 0) host = nearest_part(parts, piece);
    parts[host].outline = unite(parts[host].outline, near);
  }
}

}  // namespace relievo::understanding
