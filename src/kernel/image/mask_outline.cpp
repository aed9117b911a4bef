#include "kernel/image/mask_outline.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "kernel/geometry/simplify_line.h"
#include "kernel/image/label_rings.h"

namespace relievo {
namespace {

Image16 as_labels(const Mask& mask) {
  Image16 labels(mask.inside.width, mask.inside.height, 1);
  std::copy(mask.inside.pixels.begin(), mask.inside.pixels.end(), labels.pixels.begin());
  return labels;
}

/// Simplified in thirds, so that no piece is closed.
Ring simplified(const Ring& ring, double tolerance) {
  if (ring.size() < 8) return ring;
  const auto third = static_cast<std::ptrdiff_t>(ring.size() / 3);
  const auto last = static_cast<std::ptrdiff_t>(ring.size() - 1);
  const std::array<std::ptrdiff_t, 4> ends = {0, third, 2 * third, last};
  Ring few;
  for (size_t k = 0; k < 3; ++k) {
    const Ring piece =
        simplify_line({ring.begin() + ends[k], ring.begin() + ends[k + 1] + 1}, tolerance);
    few.insert(few.end(), piece.begin(), piece.end() - 1);
  }
  few.push_back(ring.back());
  return few;
}

/// The points of a closed ring averaged with their neighbours, `passes` times.
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

}  // namespace

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
