#include "understanding/joins/roots.h"

#include <algorithm>
#include <map>
#include <set>

namespace relievo::understanding {
namespace {

constexpr size_t noise_sides = 4;  ///< shorter runs between two others do not count

/// What is across a side.
enum class Across : uint8_t { background, behind, front };

std::vector<Across> sides_of(const PartRegions& regions, const Stacking& stacking, int part,
                             const LabelRing& ring) {
  std::vector<Across> across(ring.size(), Across::background);
  for (size_t i = 0; i < ring.size(); ++i) {
    const int other = regions.part_of(ring.beyond[i]);
    if (other >= 0)
      across[i] = stacking.rank[other] < stacking.rank[part] ? Across::behind : Across::front;
  }
  return across;
}

int most_common(const PartRegions& regions, const Stacking& stacking, int part, const Root& root) {
  std::map<int, int> sides;
  for (size_t i = 0; i < root.count; ++i) {
    const int other = regions.part_of(root.ring->beyond[(root.first + i) % root.ring->size()]);
    if (other >= 0 && stacking.rank[other] < stacking.rank[part]) ++sides[other];
  }
  const auto best = std::max_element(
      sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return best->first;
}

/// Maximal runs of sides with parts behind across them. Where a part in front hides the middle of
/// a root, and where others interrupt it for a few sides, it goes on.
std::vector<Root> roots_of(const LabelRing& ring, const std::vector<Across>& across) {
  std::vector<Root> roots;
  const size_t n = across.size();
  size_t start = 0;
  while (start < n && across[start] != Across::background) ++start;
  if (start == n) return roots;
  for (size_t i = start; i < start + n; ++i) {
    if (across[i % n] != Across::behind) continue;
    size_t last = i;
    size_t open = 0;  // sides at the background since the last one with a part behind
    for (size_t k = i; k < start + n && open < noise_sides; ++k) {
      if (across[k % n] == Across::behind) last = k;
      open = across[k % n] == Across::background ? open + 1
             : across[k % n] == Across::behind   ? 0
                                                 : open;
    }
    Root root;
    root.ring = &ring;
    root.first = i % n;
    root.count = last - i + 1;
    root.opens_before = across[(i + n - 1) % n] == Across::background;
    root.opens_after = across[(last + 1) % n] == Across::background;
    roots.push_back(root);
    i = last;
  }
  return roots;
}

}  // namespace

Surroundings surroundings(const PartRegions& regions, const Stacking& stacking, int part) {
  Surroundings around;
  around.enclosed = true;
  std::set<int> lower;
  for (const LabelRing& ring : regions.rings[part]) {
    const std::vector<Across> across = sides_of(regions, stacking, part, ring);
    for (size_t i = 0; i < ring.size(); ++i)
      if (across[i] == Across::behind) lower.insert(regions.part_of(ring.beyond[i]));
    if (ring.hole) continue;
    const auto outside = std::count_if(across.begin(), across.end(),
                                       [](Across a) { return a == Across::background; });
    if (outside > 0) around.enclosed = false;
    for (Root root : roots_of(ring, across)) {
      root.lower = most_common(regions, stacking, part, root);
      around.roots.push_back(root);
    }
  }
  around.lower.assign(lower.begin(), lower.end());
  return around;
}

}  // namespace relievo::understanding
