#include "understanding/completion/complete_parts.h"

#include <algorithm>
#include <vector>

#include "kernel/base/workers.h"
#include "kernel/image/components.h"
#include "understanding/completion/shape_candidates.h"

namespace relievo::understanding {
namespace {

constexpr double max_disagreement = 0.04;
/// A boundary that belongs to the contour fits so much better than a contour needs to.
constexpr double shaped_share = 0.4;
/// Besides, so many pixels per pixel side of the boundary are noise.
constexpr double boundary_noise = 0.25;

/// What of a candidate can be: the part's own pixels and those of its occluders, in one piece.
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

/// Explains what is seen: little of the candidate would have to be seen but is not, and little of
/// the visible part is not in it.
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
  if (!hidden.has_gaps()) return {hidden.visible(), CompletionKind::whole};
  if (const auto shape = ellipse_shape(hidden, contour_tolerance(hidden)); fits(hidden, shape))
    return {possible(hidden, *shape), CompletionKind::ellipse};
  if (const auto shape = continued_shape(hidden); fits(hidden, shape))
    return {possible(hidden, *shape), CompletionKind::continuation};
  return {possible(hidden, membrane_shape(hidden)), CompletionKind::membrane};
}

/// All parts but those.
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

int shared_sides(const PartRegions& regions, int part, int other) {
  int count = 0;
  for (const LabelRing& ring : regions.rings[part])
    for (const uint16_t label : ring.beyond)
      if (regions.part_of(label) == other) ++count;
  return count;
}

}  // namespace

Result<Completion> complete_parts(const PartRegions& regions, const Occluders& occluders,
                                  const RunContext& context) {
  context.report("complete", 0);
  Completion completion{std::vector<CompletedPart>(static_cast<size_t>(regions.count()))};
  run_tasks(regions.count(), [&](int part) {
    if (context.cancelled()) return;
    completion.parts[part] = complete(hidden_part(regions, part, occluders[part]));
  });
  if (context.cancelled()) return interrupted_error();
  return completion;
}

Result<std::vector<NeighbourEvidence>> compare_neighbours(const PartRegions& regions,
                                                          const CompletionOptions& options,
                                                          const RunContext& context) {
  Occluders others(regions.labels.size());
  for (int a = 0; a < regions.count(); ++a) others[a] = all_but(regions, {a});
  const auto completion = complete_parts(regions, others, context);
  if (!completion) return completion.error();
  std::vector<NeighbourEvidence> evidence;
  const auto adjacent = neighbours(regions, options.min_shared_sides);
  for (int a = 0; a < regions.count(); ++a)
    for (const int b : adjacent[a])
      if (a < b) evidence.push_back({a, b});
  run_tasks(static_cast<int>(evidence.size()), [&](int pair) {
    if (context.cancelled()) return;
    NeighbourEvidence& found = evidence[pair];
    found.shared = shared_sides(regions, found.a, found.b);
    found.a_below_b = pixels_of(regions, found.b, completion->parts[found.a].shape);
    found.b_below_a = pixels_of(regions, found.a, completion->parts[found.b].shape);
    found.a_shaped = is_shaped(regions, found.a, found.b);
    found.b_shaped = is_shaped(regions, found.b, found.a);
  });
  if (context.cancelled()) return interrupted_error();
  return evidence;
}

}  // namespace relievo::understanding
