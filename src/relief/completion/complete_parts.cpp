#include "relief/completion/complete_parts.h"

#include <algorithm>

#include "kernel/image/connected.h"
#include "relief/completion/shape_candidates.h"

namespace relievo {
namespace {

constexpr double max_disagreement = 0.04;

/// What of a candidate can be: the part's own pixels and those of its occluders, in one piece.
Mask possible(const HiddenPart& hidden, const Mask& candidate) {
  const Mask& visible = hidden.visible();
  Mask shape;
  shape.left = std::min(candidate.left, visible.left);
  shape.top = std::min(candidate.top, visible.top);
  const int right = std::max(candidate.right(), visible.right());
  const int bottom = std::max(candidate.bottom(), visible.bottom());
  shape.inside = Image8(right - shape.left, bottom - shape.top, 1);
  const auto add = [&](int x, int y) { shape.inside.at(x - shape.left, y - shape.top) = 1; };
  for_each_pixel(candidate, [&](int x, int y) {
    const int part = hidden.regions.part_at(x, y);
    if (part >= 0 && hidden.hides[part] != 0) add(x, y);
  });
  for_each_pixel(visible, add);
  return connected_to(shape, visible);
}

/// The larger of two shares: of the candidate that would have to be seen but is not, and of the
/// visible part that is not in it.
double disagreement(const HiddenPart& hidden, const Mask& candidate) {
  int64_t all = 0;
  int64_t outside = 0;
  for_each_pixel(candidate, [&](int x, int y) {
    const int part = hidden.regions.part_at(x, y);
    ++all;
    if (part != hidden.part && (part < 0 || hidden.hides[part] == 0)) ++outside;
  });
  int64_t missing = 0;
  for_each_pixel(hidden.visible(), [&](int x, int y) { missing += candidate.has(x, y) ? 0 : 1; });
  const auto share = [](int64_t part, int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 1.0;
  };
  return std::max(share(outside, all), share(missing, pixel_count(hidden.visible())));
}

/// Explains what is seen.
bool fits(const HiddenPart& hidden, const std::optional<Mask>& candidate) {
  return candidate && disagreement(hidden, *candidate) <= max_disagreement;
}

CompletedPart complete(const HiddenPart& hidden) {
  if (!hidden.has_gaps()) return {hidden.visible(), CompletionKind::whole};
  if (const auto shape = ellipse_shape(hidden); fits(hidden, shape))
    return {possible(hidden, *shape), CompletionKind::ellipse};
  if (const auto shape = continued_shape(hidden); fits(hidden, shape))
    return {possible(hidden, *shape), CompletionKind::continuation};
  return {possible(hidden, membrane_shape(hidden)), CompletionKind::membrane};
}

/// Pixels of `other` in what `part` becomes when `other` alone hides it.
double gain(const PartRegions& regions, int part, int other) {
  const HiddenPart hidden = hidden_part(regions, part, {other});
  if (!hidden.has_gaps()) return 0;
  const auto continued = continued_shape(hidden);
  const Mask shape =
      possible(hidden, continued ? *continued : membrane_shape(hidden));
  return static_cast<double>(pixel_count(shape) - pixel_count(regions.visible[part]));
}

int shared_sides(const PartRegions& regions, int part, int other) {
  int count = 0;
  for (const LabelRing& ring : regions.rings[part])
    for (const uint16_t label : ring.beyond)
      if (regions.part_of(label) == other) ++count;
  return count;
}

}  // namespace

Result<Completion> complete_parts(const PartRegions& regions,
                                  const Occluders& occluders, const RunContext& context) {
  Completion completion;
  for (int part = 0; part < regions.count(); ++part) {
    if (context.cancelled()) return interrupted_error();
    completion.parts.push_back(complete(hidden_part(regions, part, occluders[part])));
  }
  return completion;
}

Result<std::vector<MutualGain>> measure_gains(const PartRegions& regions,
                                              const CompletionOptions& options,
                                              const RunContext& context) {
  std::vector<MutualGain> gains;
  const auto adjacent = neighbours(regions, options.min_shared_sides);
  for (int a = 0; a < regions.count(); ++a)
    for (const int b : adjacent[a]) {
      if (b < a) continue;
      if (context.cancelled()) return interrupted_error();
      gains.push_back({a, b, gain(regions, a, b), gain(regions, b, a),
                       shared_sides(regions, a, b)});
    }
  return gains;
}

}  // namespace relievo
