#include "understanding/completion/complete_parts.h"

#include <algorithm>
#include <vector>

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

/// The pixels of a candidate that are the part's own or its occluders', in one piece.
Mask possible(const HiddenPart& hidden, const Mask& candidate) {
  const Mask& visible = hidden.visible();
  Mask shape = empty_mask(
      std::min(candidate.left, visible.left), std::min(candidate.top, visible.top),
      std::max(candidate.right(), visible.right()), std::max(candidate.bottom(), visible.bottom()));
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

}  // namespace relievo::understanding
