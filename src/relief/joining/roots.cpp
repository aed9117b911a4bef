#include "relief/joining/roots.h"

#include <algorithm>
#include <map>
#include <set>

namespace relievo {
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

/// Maximal runs of sides with parts behind across them; short interruptions do not end one.
std::vector<Root> roots_of(const LabelRing& ring, const std::vector<Across>& across) {
  std::vector<Root> roots;
  const size_t n = across.size();
  size_t start = 0;
  while (start < n && across[start] == Across::behind) ++start;
  if (start == n) return roots;
  for (size_t i = start; i < start + n; ++i) {
    if (across[i % n] != Across::behind) continue;
    Root root;
    root.ring = &ring;
    root.first = i % n;
    size_t gap = 0;
    size_t length = 0;
    while (i + length < start + n && gap < noise_sides) {
      gap = across[(i + length) % n] == Across::behind ? 0 : gap + 1;
      ++length;
    }
    root.count = length - gap;
    root.opens_before = across[(root.first + n - 1) % n] == Across::background;
    root.opens_after = across[(root.first + root.count) % n] == Across::background;
    i += length;
    roots.push_back(root);
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
    const auto outside =
        std::count_if(across.begin(), across.end(), [](Across a) { return a != Across::behind; });
    if (outside > 0) around.enclosed = false;
    for (Root root : roots_of(ring, across)) {
      root.lower = most_common(regions, stacking, part, root);
      around.roots.push_back(root);
    }
  }
  around.lower.assign(lower.begin(), lower.end());
  return around;
}

}  // namespace relievo
