#include "understanding/completion/complete_parts.h"

#include <algorithm>
#include <utility>

#include "kernel/base/workers.h"
#include "kernel/image/components.h"
#include "understanding/completion/shape_candidates.h"

namespace relievo::understanding {
namespace {

/// The share of a candidate, and of the visible part, that may disagree with the other.
constexpr double max_disagreement = 0.04;
/// Pixels that disagree as noise, per pixel side of the part's boundary.
constexpr double boundary_noise = 0.25;
/// A common boundary counts as a part's own contour where an ellipse fits the contour with it
/// within this share of contour_tolerance.
constexpr double shaped_share = 0.4;
/// Parts with a shorter common boundary, in pixel sides, are not compared.
constexpr int min_shared_sides = 4;

/// An empty set in the box around both sets, grown by `margin` px and clipped to the canvas.
Mask joint_box(const Mask& a, const Mask& b, int margin, const Image16& canvas) {
  return empty_mask(std::max(0, std::min(a.left, b.left) - margin),
                    std::max(0, std::min(a.top, b.top) - margin),
                    std::min(canvas.width, std::max(a.right(), b.right()) + margin),
                    std::min(canvas.height, std::max(a.bottom(), b.bottom()) + margin));
}

/// The pixels of a candidate that are the part's own or its occluders', in one piece.
Mask possible(const HiddenPart& hidden, const Mask& candidate) {
  const Mask& visible = hidden.visible();
  Mask shape = joint_box(candidate, visible, 0, hidden.regions.map);
  for_each_pixel(candidate, [&](int x, int y) {
    const int part = hidden.regions.part_at(x, y);
    if (part >= 0 && hidden.hides[part] != 0) shape.add(x, y);
  });
  for_each_pixel(visible, [&](int x, int y) { shape.add(x, y); });
  return connected_to(shape, visible);
}

double boundary_length(const HiddenPart& hidden) {
  size_t sides = 0;
  for (const LabelRing& ring : hidden.rings()) sides += ring.size();
  return static_cast<double>(sides);
}

/// Whether a candidate explains what is seen: few of its pixels should be visible but are not, and
/// few pixels of the visible part lie outside it.
bool fits(const HiddenPart& hidden, const std::optional<Mask>& candidate) {
  if (!candidate) return false;
  int64_t outside = 0;
  for_each_pixel(*candidate, [&](int x, int y) {
    const int part = hidden.regions.part_at(x, y);
    if (part != hidden.part && (part < 0 || hidden.hides[part] == 0)) ++outside;
  });
  int64_t missing = 0;
  for_each_pixel(hidden.visible(), [&](int x, int y) { missing += candidate->has(x, y) ? 0 : 1; });
  const double noise = boundary_noise * boundary_length(hidden);
  const auto allowed = [noise](int64_t pixels) {
    return max_disagreement * static_cast<double>(pixels) + noise;
  };
  return static_cast<double>(outside) <= allowed(pixel_count(*candidate)) &&
         static_cast<double>(missing) <= allowed(pixel_count(hidden.visible()));
}

CompletedPart complete(const HiddenPart& hidden) {
  if (!hidden.has_gaps()) return {hidden.visible(), CompletionKind::whole, {}};
  if (const auto shape = ellipse_shape(hidden, contour_tolerance(hidden)); fits(hidden, shape))
    return {possible(hidden, *shape), CompletionKind::ellipse, {}};
  if (const auto shape = continued_shape(hidden); fits(hidden, shape))
    return {possible(hidden, *shape), CompletionKind::continuation, {}};
  return {possible(hidden, membrane_shape(hidden)), CompletionKind::membrane, {}};
}

/// All parts except the given ones, sorted.
std::vector<int> all_but(const PartRegions& regions, const std::vector<int>& parts) {
  std::vector<int> others;
  for (int part = 0; part < regions.count(); ++part)
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) others.push_back(part);
  return others;
}

double pixels_of(const PartRegions& regions, int part, const Mask& shape) {
  double count = 0;
  for_each_pixel(shape, [&](int x, int y) { count += regions.part_at(x, y) == part ? 1 : 0; });
  return count;
}

/// Whether the part's known contour together with its boundary to `other` is still an ellipse.
bool is_shaped(const PartRegions& regions, int part, int other) {
  const HiddenPart hidden = hidden_part(regions, part, all_but(regions, {part, other}));
  return fits(hidden, ellipse_shape(hidden, shaped_share * contour_tolerance(hidden)));
}

/// Distance that hidden regions keep from where their occluders end, px.
constexpr int rim_margin = 2;

/// Returns whether the test holds in the square of `radius` around a pixel.
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

/// Returns whether the completion below the parts in front restricts the other one: a membrane,
/// which fits anything, does not restrict an ellipse or a continuation.
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

Result<Completion> complete_parts(const PartRegions& regions, const Occluders& occluders,
                                  const RunContext& context,
                                  std::initializer_list<const Completion*> known) {
  context.report("complete", 0);
  Completion completion(regions.labels.size());
  run_tasks(regions.count(), [&](int part) {
    if (context.cancelled()) return;
    const auto same = std::find_if(known.begin(), known.end(), [&](const Completion* earlier) {
      return (*earlier)[part].occluders == occluders[part];
    });
    completion[part] = same == known.end() ? complete(hidden_part(regions, part, occluders[part]))
                                           : (**same)[part];
    completion[part].occluders = occluders[part];
  });
  if (context.cancelled()) return interrupted_error();
  return completion;
}

Occluders all_others(const PartRegions& regions) {
  Occluders others;
  for (int part = 0; part < regions.count(); ++part) others.push_back(all_but(regions, {part}));
  return others;
}

Result<std::vector<NeighbourEvidence>> compare_neighbours(const PartRegions& regions,
                                                          const Completion& completion,
                                                          const RunContext& context) {
  std::vector<NeighbourEvidence> evidence;
  for (int a = 0; a < regions.count(); ++a)
    for (const auto& [b, shared] : shared_sides(regions, a))
      if (a < b && shared >= min_shared_sides)
        evidence.push_back({regions.labels[a], regions.labels[b], shared});
  run_tasks(static_cast<int>(evidence.size()), [&](int pair) {
    if (context.cancelled()) return;
    NeighbourEvidence& found = evidence[pair];
    const int a = regions.part_of(found.a);
    const int b = regions.part_of(found.b);
    found.a_below_b = pixels_of(regions, b, completion[a].shape);
    found.b_below_a = pixels_of(regions, a, completion[b].shape);
    found.a_shaped = is_shaped(regions, a, b);
    found.b_shaped = is_shaped(regions, b, a);
  });
  if (context.cancelled()) return interrupted_error();
  return evidence;
}

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
