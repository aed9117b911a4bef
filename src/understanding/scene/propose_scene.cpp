#include "understanding/scene/propose_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "kernel/base/text_rules.h"
#include "kernel/image/outlines.h"
#include "understanding/joins/part_profile.h"
#include "understanding/joins/propose_joins.h"
#include "understanding/joins/propose_leans.h"
#include "understanding/scene/keep_edits.h"
#include "understanding/stacking/stack_parts.h"

namespace relievo::understanding {
namespace {

constexpr int max_parts = 1024;
/// The least distance that parts reach below their neighbours: a share of the drawing's diagonal,
/// but at least so many px.
constexpr double overlap_share = 0.005;
constexpr double min_overlap = 2;
/// The tremor of a hand, and the error of its lines as they are found: a share of the diagonal.
constexpr double tremor_share = 0.0015;
/// The contour of a part that others surround is its own above this confidence of an arrow.
constexpr double sure_arrow = 0.97;

using LabelPair = std::pair<PartLabel, PartLabel>;

/// Sets labels with few pixels to background.
Image16 without_specks(const Image16& labels, std::vector<std::string>& warnings) {
  std::map<PartLabel, int> pixels;
  for (const PartLabel label : labels.pixels)
    if (label != 0) ++pixels[label];
  int specks = 0;
  for (const auto& [label, count] : pixels) specks += count < least_part_pixels ? 1 : 0;
  if (specks == 0) return labels;
  warnings.push_back(std::to_string(specks) + " labels have fewer than " +
                     std::to_string(least_part_pixels) + " pixels and are left out");
  Image16 kept = labels;
  for (PartLabel& label : kept.pixels)
    if (label != 0 && pixels[label] < least_part_pixels) label = 0;
  return kept;
}

/// Calls visit(label) for every label in the corrections.
template <class Visit>
void for_each_label(const Corrections& corrections, Visit visit) {
  const auto both = [&](const auto& item) {
    visit(item.upper);
    visit(item.lower);
  };
  for (const auto& [label, correction] : corrections.parts) visit(label);
  for (const auto& [upper, lower] : corrections.order) {
    visit(upper);
    visit(lower);
  }
  for (const Join& join : corrections.joins) both(join);
  for (const auto& [upper, lower] : corrections.no_joins) {
    visit(upper);
    visit(lower);
  }
  for (const Relation& relation : corrections.relations) both(relation);
  for (const RobinRange& range : corrections.robin) both(range);
  for (const Cue& cue : corrections.cues) visit(cue.part);
}

Status check_labels(const PartRegions& regions, const Corrections& corrections) {
  if (regions.count() == 0)
    return Error{ErrorCode::bad_input, "has no parts: every pixel is background", "labels"};
  if (regions.count() > max_parts)
    return Error{ErrorCode::limit, "has more than " + std::to_string(max_parts) + " parts",
                 "labels"};
  Status status = Done{};
  for_each_label(corrections, [&](int label) {
    const bool known = label > 0 && label < static_cast<int>(regions.part_of_label.size()) &&
                       regions.part_of_label[label] >= 0;
    if (!known && status)
      status =
          Error{ErrorCode::bad_input, "no part has this label", "label " + std::to_string(label)};
  });
  return status;
}

/// The pairs that the user ordered. A join or relation orders its parts as well.
std::vector<LabelPair> user_arrows(const Corrections& corrections) {
  std::vector<LabelPair> arrows = corrections.order;
  for (const Join& join : corrections.joins) arrows.push_back(LabelPair(join.upper, join.lower));
  for (const Relation& relation : corrections.relations)
    arrows.push_back(LabelPair(relation.upper, relation.lower));
  std::sort(arrows.begin(), arrows.end());
  arrows.erase(std::unique(arrows.begin(), arrows.end()), arrows.end());
  return arrows;
}

/// The parts that may hide each part: all others, except where the user says otherwise, where the
/// boundary between two parts is the contour of the front one, and where the front one is
/// surrounded by others, since nothing else would be known of its contour.
Occluders possible_occluders(const PartRegions& regions,
                             const std::vector<NeighbourEvidence>& evidence,
                             const std::vector<OrderArrow>& order,
                             const std::vector<LabelPair>& user) {
  const int count = regions.count();
  std::vector<std::vector<uint8_t>> hides(count, std::vector<uint8_t>(count, 1));
  const auto set = [&](PartLabel part, PartLabel other, bool may_hide) {
    hides[regions.part_of(part)][regions.part_of(other)] = may_hide ? 1 : 0;
  };
  for (const NeighbourEvidence& pair : evidence) {
    if (pair.a_shaped && !pair.b_shaped) set(pair.a, pair.b, false);
    if (pair.b_shaped && !pair.a_shaped) set(pair.b, pair.a, false);
  }
  for (const OrderArrow& arrow : order)
    if (arrow.kept && arrow.confidence >= sure_arrow &&
        !touches_background(regions, regions.part_of(arrow.upper)))
      set(arrow.upper, arrow.lower, false);
  for (const auto& [upper, lower] : user) {
    set(lower, upper, true);
    set(upper, lower, false);
  }
  Occluders occluders(count);
  for (int part = 0; part < count; ++part)
    for (int other = 0; other < count; ++other)
      if (other != part && hides[part][other] != 0) occluders[part].push_back(other);
  return occluders;
}

/// For each part, all parts in front of it.
Occluders parts_in_front(const PartRegions& regions, const std::vector<PartLabel>& back_to_front) {
  Occluders occluders(back_to_front.size());
  std::vector<int> front;
  for (auto label = back_to_front.rbegin(); label != back_to_front.rend(); ++label) {
    const int part = regions.part_of(*label);
    occluders[part] = front;
    front.insert(std::lower_bound(front.begin(), front.end(), part), part);
  }
  return occluders;
}

/// Sorts the regions and what belongs to them back to front.
void sort_parts(const std::vector<PartLabel>& back_to_front, PartRegions& regions,
                Completion& completion, Completion& below_front) {
  for (Completion* shapes : {&completion, &below_front}) {
    Completion sorted;
    for (const PartLabel label : back_to_front)
      sorted.push_back(std::move((*shapes)[regions.part_of(label)]));
    *shapes = std::move(sorted);
  }
  sort_regions(back_to_front, regions);
}

void keep_given_outlines(const Corrections& corrections, const PartRegions& regions,
                         Completion& completion) {
  for (const auto& [label, correction] : corrections.parts)
    if (correction.outline)
      completion[regions.part_of(label)] = {
          fill_outline(*correction.outline, regions.map.width, regions.map.height),
          CompletionKind::given,
          {}};
}

/// Orders and completes the parts of `proposal.regions`, which are sorted back to front then.
/// Returns their shapes as the order of parts lets them be.
Result<Completion> order_parts(const Corrections& corrections, const DrawingEvidence& drawing,
                               const RunContext& context, Proposal& proposal) {
  PartRegions& regions = proposal.regions;
  const auto unordered = complete_parts(regions, all_others(regions), context);
  if (!unordered) return unordered.error();
  auto evidence = compare_neighbours(regions, *unordered, context);
  if (!evidence) return evidence.error();
  proposal.evidence = std::move(*evidence);
  for (NeighbourEvidence& pair : proposal.evidence) {
    pair.open = drawing.is_open(pair.a, pair.b);
    pair.front = drawing.front_of(pair.a, pair.b);
  }
  const std::vector<LabelPair> user = user_arrows(corrections);
  auto stacking = stack_parts(regions, proposal.evidence, user);
  if (!stacking) return stacking.error();
  proposal.order = std::move(stacking->arrows);
  const Occluders occluders = possible_occluders(regions, proposal.evidence, proposal.order, user);
  auto completion = complete_parts(regions, occluders, context, {&*unordered});
  if (!completion) return completion.error();
  auto below_front = complete_parts(regions, parts_in_front(regions, stacking->back_to_front),
                                    context, {&*completion, &*unordered});
  if (!below_front) return below_front.error();
  keep_given_outlines(corrections, regions, *completion);
  sort_parts(stacking->back_to_front, regions, *completion, *below_front);
  proposal.completion = std::move(*completion);
  const double overlap =
      std::max(min_overlap, overlap_share * std::hypot(regions.map.width, regions.map.height));
  return clip_to_order(regions, proposal.completion, *below_front,
                       static_cast<int>(std::lround(overlap)));
}

/// Adds the ink of the parts' outlines to their shapes.
void add_ink(const PartRegions& regions, Completion& shapes) {
  for (int part = 0; part < regions.count(); ++part) {
    const Mask& a = shapes[part].shape;
    const Mask& b = regions.inked[part];
    Mask both = empty_mask(std::min(a.left, b.left), std::min(a.top, b.top),
                           std::max(a.right(), b.right()), std::max(a.bottom(), b.bottom()));
    for_each_pixel(a, [&](int x, int y) { both.add(x, y); });
    for_each_pixel(b, [&](int x, int y) { both.add(x, y); });
    shapes[part].shape = std::move(both);
  }
}

/// The factor of c of a part that is a feature of all parts that it is tied to and touches; 1 for
/// others.
double inflation_factor(const Proposal& proposal, const Completion& shapes, int part) {
  if (touches_background(proposal.regions, part)) return 1;
  const std::vector<PartLabel>& labels = proposal.regions.labels;
  const auto touch = [&](int lower) {
    return std::any_of(proposal.evidence.begin(), proposal.evidence.end(), [&](const auto& pair) {
      return std::minmax(pair.a, pair.b) == std::minmax(labels[part], labels[lower]);
    });
  };
  const auto area = [&](int k) { return static_cast<double>(pixel_count(shapes[k].shape)); };
  double below = 0;
  for (const ProposedRelation& proposed : proposal.joining.relations) {
    const Relation& relation = proposed.relation;
    if (relation.upper == part && is_tie(relation.kind) && touch(relation.lower))
      below += area(relation.lower);
  }
  return below == 0 ? 1 : feature_inflation(area(part) / below);
}

/// Options for outlines as smooth as a hand draws them on a canvas of this size.
OutlineOptions smooth_outlines(const Image16& map) {
  OutlineOptions options;
  const double scale = std::max(1.0, tremor_share * std::hypot(map.width, map.height));
  options.reach *= scale;
  options.wavelength *= scale;
  return options;
}

/// The user's corrections of a part.
PartCorrection correction_of(const Corrections& corrections, PartLabel label) {
  const auto found = corrections.parts.find(label);
  return found == corrections.parts.end() ? PartCorrection{} : found->second;
}

/// The outlines in the scene: the user's, or those of the shapes.
std::vector<Outline> scene_outlines(const Corrections& corrections, const PartRegions& regions,
                                    const Completion& shapes) {
  const OutlineOptions options = smooth_outlines(regions.map);
  std::vector<Outline> outlines;
  for (int part = 0; part < regions.count(); ++part) {
    const PartCorrection given = correction_of(corrections, regions.labels[part]);
    outlines.push_back(given.outline ? *given.outline : outline_of(shapes[part].shape, options));
    orient_by_nesting(outlines.back());
  }
  return outlines;
}

/// The id of a part after its label, unless the user gave that to another part.
std::string proposed_id(const Corrections& corrections, PartLabel label) {
  return free_name("part-" + std::to_string(label), [&](const std::string& id) {
    return std::any_of(corrections.parts.begin(), corrections.parts.end(),
                       [&](const auto& part) { return part.second.id == id; });
  });
}

double rounded(double value) { return std::round(value * 100) / 100; }

/// The parts of the scene as proposed, with the user's corrections.
std::vector<Part> scene_parts(const Corrections& corrections, const Proposal& proposal,
                              const Completion& shapes, const std::vector<Outline>& outlines) {
  const std::vector<uint8_t> backdrops =
      find_backdrops(proposal.regions, shapes, proposal.joining.joins);
  std::vector<Point2> leans(outlines.size());
  for (const ProposedLean& proposed : proposal.joining.leans)
    leans[proposed.part] = {rounded(proposed.lean.x), rounded(proposed.lean.y)};
  std::vector<Part> parts;
  for (int k = 0; k < proposal.regions.count(); ++k) {
    const PartLabel label = proposal.regions.labels[k];
    const PartCorrection given = correction_of(corrections, label);
    double c = round_inflation(shapes[k].shape) * inflation_factor(proposal, shapes, k);
    if (backdrops[k] != 0) c *= backdrop_inflation;
    Part part;
    part.id = given.id ? *given.id : proposed_id(corrections, label);
    part.outline = outlines[k];
    part.c = given.c.value_or(rounded(c));
    part.d = given.d.value_or(1);
    part.flat = given.flat.value_or(backdrops[k] != 0 ? backdrop_flat : 0);
    part.lean = given.lean.value_or(leans[k]);
    parts.push_back(std::move(part));
  }
  return parts;
}

Scene scene_of(const Corrections& corrections, const Proposal& proposal, const Completion& shapes,
               const std::vector<Outline>& outlines) {
  Scene scene;
  scene.width = proposal.regions.map.width;
  scene.height = proposal.regions.map.height;
  scene.parts = scene_parts(corrections, proposal, shapes, outlines);
  for (const ProposedJoin& join : proposal.joining.joins) scene.joins.push_back(join.join);
  for (const ProposedRelation& relation : proposal.joining.relations)
    scene.relations.push_back(relation.relation);
  scene.robin = proposal.joining.robin;
  scene.cues = corrections.cues;
  for (Cue& cue : scene.cues) cue.part = proposal.regions.part_of(static_cast<PartLabel>(cue.part));
  return scene;
}

}  // namespace

Result<Proposal> propose_scene(const Image16& labels, const Corrections& corrections,
                               const DrawingEvidence& drawing, const RunContext& context) {
  Proposal proposal;
  proposal.regions = find_regions(without_specks(labels, proposal.warnings), drawing.rim);
  if (Status s = check_labels(proposal.regions, corrections); !s) return s.error();
  auto shapes = order_parts(corrections, drawing, context, proposal);
  if (!shapes) return shapes.error();
  const PartRegions& regions = proposal.regions;
  if (drawing.rim > 0) add_ink(regions, *shapes);
  const std::vector<Outline> outlines = scene_outlines(corrections, regions, *shapes);
  JoinProposals& joining = proposal.joining;
  joining = propose_joins(regions, outlines, proposal.order, corrections, drawing);
  joining.leans = propose_leans(regions, proposal.order, *shapes, joining.joins);
  std::erase_if(joining.leans, [&](const ProposedLean& lean) {
    return correction_of(corrections, regions.labels[lean.part]).lean.has_value();
  });
  proposal.scene = scene_of(corrections, proposal, *shapes, outlines);
  if (Status s = validate(proposal.scene); !s) return s.error();
  return proposal;
}

}  // namespace relievo::understanding
