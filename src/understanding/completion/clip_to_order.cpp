#include "understanding/completion/clip_to_order.h"

#include <algorithm>
#include <utility>

#include "kernel/image/components.h"

namespace relievo::understanding {
namespace {

/// An empty set in the box around both sets, grown by `margin` px and clipped to the canvas.
Mask joint_box(const Mask& a, const Mask& b, int margin, const Image16& canvas) {
  return empty_mask(std::max(0, std::min(a.left, b.left) - margin),
                    std::max(0, std::min(a.top, b.top) - margin),
                    std::min(canvas.width, std::max(a.right(), b.right()) + margin),
                    std::min(canvas.height, std::max(a.bottom(), b.bottom()) + margin));
}

/// Distance that hidden regions keep from where their occluders end, px.
constexpr int rim_margin = 2;

/// Whether the test holds in the square of `radius` around a pixel.
template <class Test>
bool all_around(int x, int y, int radius, Test test) {
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx)
      if (!test(x + dx, y + dy)) return false;
  return true;
}

/// The pixels that are in both sets.
Mask common(const Mask& a, const Mask& b) {
  Mask both = a;
  for_each_pixel(a, [&](int x, int y) {
    if (!b.has(x, y)) both.remove(x, y);
  });
  return both;
}

/// Whether the completion below the parts in front restricts the other one: a membrane, which fits
/// anything, does not restrict an ellipse or a continuation.
bool limits(const CompletedPart& below_front, const CompletedPart& completed) {
  return below_front.kind != CompletionKind::membrane || completed.kind == CompletionKind::membrane;
}

/// Adds the pixels within `steps` of `seed` that `allowed` accepts, walking only through those.
template <class Allowed>
void grow(Mask& mask, const Mask& seed, int steps, Allowed allowed) {
  std::vector<std::pair<int, int>> front;
  Mask reached = empty_mask(mask.left, mask.top, mask.right(), mask.bottom());
  for_each_pixel(seed, [&](int x, int y) {
    reached.add(x, y);
    front.emplace_back(x, y);
  });
  for (int step = 0; step < steps; ++step) {
    std::vector<std::pair<int, int>> next;
    const auto reach = [&](int x, int y) {
      if (!reached.covers(x, y) || reached.has(x, y) || !allowed(x, y)) return;
      reached.add(x, y);
      mask.add(x, y);
      next.emplace_back(x, y);
    };
    for (const auto& [x, y] : front) {
      reach(x - 1, y);
      reach(x + 1, y);
      reach(x, y - 1);
      reach(x, y + 1);
    }
    front.swap(next);
  }
}

Mask clipped(const PartRegions& regions, const Mask& shape, int part, int overlap) {
  const Mask& visible = regions.visible[part];
  Mask result = joint_box(shape, visible, overlap, regions.map);
  const auto below_another = [&](int x, int y) { return regions.part_at(x, y) > part; };
  const auto own_or_below = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= regions.map.width || y >= regions.map.height) return false;
    return regions.part_at(x, y) == part || below_another(x, y);
  };
  const auto well_below = [&](int x, int y) {
    return below_another(x, y) && all_around(x, y, rim_margin, own_or_below);
  };
  for_each_pixel(shape, [&](int x, int y) {
    if (well_below(x, y)) result.add(x, y);
  });
  for_each_pixel(visible, [&](int x, int y) { result.add(x, y); });
  grow(result, visible, overlap, well_below);
  return connected_to(result, visible);
}

}  // namespace

Completion clip_to_order(const PartRegions& regions, const Completion& completion,
                         const Completion& below_front, int overlap) {
  Completion result = completion;
  for (int part = 0; part < regions.count(); ++part) {
    CompletedPart& completed = result[part];
    if (completed.kind == CompletionKind::given) continue;
    const CompletedPart& limit = below_front[part];
    const Mask shape =
        limits(limit, completed) ? common(completed.shape, limit.shape) : completed.shape;
    completed.shape = clipped(regions, shape, part, overlap);
  }
  return result;
}

}  // namespace relievo::understanding
