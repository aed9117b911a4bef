#include "understanding/joins/roots.h"

#include <algorithm>
#include <map>
#include <set>

namespace relievo::understanding {
namespace {

constexpr size_t noise_sides = 4;  ///< shorter interruptions of a root by the background are noise

/// What is across a pixel side.
enum class Across : uint8_t { background, behind, front };

std::vector<Across> sides_of(const PartRegions& regions, int part, const LabelRing& ring) {
  std::vector<Across> across(ring.size(), Across::background);
  for (size_t i = 0; i < ring.size(); ++i)
    if (const int other = regions.part_of(ring.beyond[i]); other >= 0)
      across[i] = other < part ? Across::behind : Across::front;
  return across;
}

/// The part behind that a root borders on most; of equals the one with the smallest label.
int most_common(const PartRegions& regions, int part, const Root& root) {
  std::map<PartLabel, int> sides;
  for (size_t i = 0; i < root.count; ++i) {
    const PartLabel label = root.ring->beyond[(root.first + i) % root.ring->size()];
    const int other = regions.part_of(label);
    if (other >= 0 && other < part) ++sides[label];
  }
  const auto best = std::max_element(
      sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return regions.part_of(best->first);
}

/// Maximal runs of sides with parts behind across them. A root continues across sides with parts in
/// front, and across a few sides with background.
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

Surroundings surroundings(const PartRegions& regions, int part) {
  Surroundings around;
  around.enclosed = true;
  std::set<PartLabel> lower;
  for (const LabelRing& ring : regions.rings[part]) {
    const std::vector<Across> across = sides_of(regions, part, ring);
    for (size_t i = 0; i < ring.size(); ++i)
      if (across[i] == Across::behind) lower.insert(ring.beyond[i]);
    if (ring.hole) continue;
    if (std::find(across.begin(), across.end(), Across::background) != across.end())
      around.enclosed = false;
    for (Root root : roots_of(ring, across)) {
      root.lower = most_common(regions, part, root);
      around.roots.push_back(root);
    }
  }
  for (const PartLabel label : lower) around.lower.push_back(regions.part_of(label));
  return around;
}

}  // namespace relievo::understanding
