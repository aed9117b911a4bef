#include "kernel/image/mask_outline.h"

#include <algorithm>

#include "kernel/geometry/ring_measure.h"
#include "kernel/image/label_rings.h"

namespace relievo {
namespace {

Image16 as_labels(const Mask& mask) {
  Image16 labels(mask.inside.width, mask.inside.height, 1);
  std::copy(mask.inside.pixels.begin(), mask.inside.pixels.end(), labels.pixels.begin());
  return labels;
}

/// Marks the points of ring[first..last] that are kept, its ends included (Douglas and Peucker).
void keep_points(const Ring& ring, size_t first, size_t last, double tolerance,
                 std::vector<uint8_t>& keep) {
  std::vector<std::pair<size_t, size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    size_t farthest = a;
    double largest = tolerance;
    for (size_t i = a + 1; i < b; ++i) {
      const double d = distance_to_segment(ring[i], ring[a], ring[b]);
      if (d <= largest) continue;
      largest = d;
      farthest = i;
    }
    if (farthest == a) continue;
    keep[farthest] = 1;
    open.emplace_back(a, farthest);
    open.emplace_back(farthest, b);
  }
}

Ring simplified(const Ring& ring, double tolerance) {
  if (ring.size() < 8) return ring;
  std::vector<uint8_t> keep(ring.size(), 0);
  // Fixed points a third apart, so that no piece is closed.
  const size_t third = ring.size() / 3;
  for (const size_t i : {size_t{0}, third, 2 * third, ring.size() - 1}) keep[i] = 1;
  keep_points(ring, 0, third, tolerance, keep);
  keep_points(ring, third, 2 * third, tolerance, keep);
  keep_points(ring, 2 * third, ring.size() - 1, tolerance, keep);
  Ring few;
  for (size_t i = 0; i < ring.size(); ++i)
    if (keep[i] != 0) few.push_back(ring[i]);
  return few;
}

}  // namespace

Ring smoothed(Ring ring, int passes) {
  const size_t n = ring.size();
  if (n < 3) return ring;
  Ring next(n);
  for (int pass = 0; pass < passes; ++pass) {
    for (size_t i = 0; i < n; ++i)
      next[i] = 0.25 * ring[(i + n - 1) % n] + (0.5 * ring[i] + 0.25 * ring[(i + 1) % n]);
    ring.swap(next);
  }
  return ring;
}

Outline outline_of(const Mask& mask, const OutlineOptions& options) {
  const std::vector<LabelRing> rings = trace_label_rings(as_labels(mask));
  size_t longest = 0;
  for (const LabelRing& ring : rings) longest = std::max(longest, ring.size());
  const size_t least = std::min(static_cast<size_t>(options.min_sides), longest);
  Outline outline;
  for (const LabelRing& traced : rings) {
    if (traced.size() < least) continue;
    Ring ring = traced.sides;
    const Point2 offset{static_cast<double>(mask.left), static_cast<double>(mask.top)};
    for (Point2& p : ring) p = p + offset;
    outline.push_back(simplified(smoothed(std::move(ring), options.smoothing), options.tolerance));
  }
  return outline;
}

}  // namespace relievo
