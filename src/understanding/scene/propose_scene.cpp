#include "understanding/scene/propose_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "kernel/base/text_rules.h"
#include "kernel/image/outlines.h"
#include "understanding/completion/clip_to_order.h"
#include "understanding/joins/part_profile.h"
#include "understanding/joins/propose_leans.h"
#include "understanding/scene/outline_rim.h"

namespace relievo::understanding {
namespace {

/// How far parts reach below their neighbours at least: a share of the drawing's diagonal.
constexpr double overlap_share = 0.005;
constexpr double min_overlap = 2;  ///< px
/// How far a hand, and what is found of its lines, trembles: a share of the diagonal.
constexpr double tremor_share = 0.0015;
/// Arrows that are surer than this tell that a surrounded part's contour is its own.
constexpr double sure_arrow = 0.97;

Error no_such_label(int label) {
  return {ErrorCode::bad_input, "no part has this label", "label " + std::to_string(label)};
}

/// Small labels become background.
Image16 without_specks(const Image16& labels, int min_pixels, std::vector<std::string>& warnings) {
  std::map<uint16_t, int> pixels;
  for (const uint16_t label : labels.pixels)
    if (label != 0) ++pixels[label];
  int specks = 0;
  for (const auto& [label, count] : pixels) specks += count < min_pixels ? 1 : 0;
  if (specks == 0) return labels;
  warnings.push_back(std::to_string(specks) + " labels have fewer than " +
                     std::to_string(min_pixels) + " pixels and are left out");
  Image16 kept = labels;
  for (uint16_t& label : kept.pixels)
    if (label != 0 && pixels[label] < min_pixels) label = 0;
  return kept;
}

/// Turns labels in the user's corrections into part indices.
class LabelResolver {
 public:
  explicit LabelResolver(const PartRegions& regions) : regions_(regions) {}

  int part(int label) {
    const bool known = label > 0 && label < static_cast<int>(regions_.part_of_label.size()) &&
                       regions_.part_of_label[label] >= 0;
    if (!known && !error_) error_ = no_such_label(label);
    return known ? regions_.part_of_label[label] : 0;
  }

  template <class Item>
  void pair(Item& item) {
    item.upper = part(item.upper);
    item.lower = part(item.lower);
  }

  JoinCorrections joining(JoinCorrections corrections) {
    for (Join& join : corrections.joins) pair(join);
    for (auto& [upper, lower] : corrections.no_joins) {
      upper = part(upper);
      lower = part(lower);
    }
    for (Relation& relation : corrections.relations) pair(relation);
    for (RobinRange& range : corrections.robin) pair(range);
    return corrections;
  }

  std::vector<Cue> cues(std::vector<Cue> cues) {
    for (Cue& cue : cues) cue.part = part(cue.part);
    return cues;
  }

  std::vector<UserArrow> arrows(const Corrections& corrections) {
    std::vector<UserArrow> arrows;
    for (const auto& [upper, lower] : corrections.order)
      arrows.emplace_back(part(upper), part(lower));
    // A join or relation says as well which part is in front.
    const JoinCorrections own = joining(corrections.joining);
    for (const Join& join : own.joins) arrows.emplace_back(join.upper, join.lower);
    for (const Relation& relation : own.relations)
      arrows.emplace_back(relation.upper, relation.lower);
    std::sort(arrows.begin(), arrows.end());
    arrows.erase(std::unique(arrows.begin(), arrows.end()), arrows.end());
    return arrows;
  }

  const std::optional<Error>& error() const { return error_; }

 private:
  const PartRegions& regions_;
  std::optional<Error> error_;
};

bool touches_background(const PartRegions& regions, int part) {
  for (const LabelRing& ring : regions.rings[part])
    if (std::count(ring.beyond.begin(), ring.beyond.end(), 0) > 0) return true;
  return false;
}

/// Who may hide whom: everybody, except where the user says otherwise, where the boundary between
/// two parts is the front one's own contour, and parts behind one that is surrounded by others,
/// of whose contour nothing else would be known.
Occluders possible_occluders(const Proposal& proposal, const std::vector<UserArrow>& arrows) {
  const int count = proposal.regions.count();
  std::vector<std::vector<uint8_t>> hides(count, std::vector<uint8_t>(count, 1));
  for (const NeighbourEvidence& pair : proposal.evidence) {
    if (pair.a_shaped && !pair.b_shaped) hides[pair.a][pair.b] = 0;
    if (pair.b_shaped && !pair.a_shaped) hides[pair.b][pair.a] = 0;
  }
  for (const OrderArrow& arrow : proposal.stacking.arrows)
    if (arrow.kept && arrow.confidence >= sure_arrow &&
        !touches_background(proposal.regions, arrow.upper))
      hides[arrow.upper][arrow.lower] = 0;
  for (const auto& [upper, lower] : arrows) {
    hides[lower][upper] = 1;
    hides[upper][lower] = 0;
  }
  Occluders occluders(count);
  for (int part = 0; part < count; ++part)
    for (int other = 0; other < count; ++other)
      if (other != part && hides[part][other] != 0) occluders[part].push_back(other);
  return occluders;
}

/// Everybody in front.
Occluders parts_in_front(const std::vector<int>& rank) {
  Occluders occluders(rank.size());
  for (size_t part = 0; part < rank.size(); ++part)
    for (size_t other = 0; other < rank.size(); ++other)
      if (rank[other] > rank[part]) occluders[part].push_back(static_cast<int>(other));
  return occluders;
}

/// The shapes as the order of parts lets them be.
Result<Completion> shapes_in_order(const Proposal& proposal, const RunContext& context) {
  const std::vector<int>& rank = proposal.stacking.rank;
  const auto below_front = complete_parts(proposal.regions, parts_in_front(rank), context);
  if (!below_front) return below_front.error();
  const Image16& map = proposal.regions.map;
  const double overlap = std::max(min_overlap, overlap_share * std::hypot(map.width, map.height));
  return clip_to_order(proposal.regions, proposal.completion, *below_front, rank,
                       static_cast<int>(std::lround(overlap)));
}

void keep_given_outlines(const Corrections& corrections, Proposal& proposal) {
  for (const auto& [label, correction] : corrections.parts) {
    if (!correction.outline) continue;
    const int part = proposal.regions.part_of(label);
    const Image16& map = proposal.regions.map;
    proposal.completion.parts[part] = {fill_outline(*correction.outline, map.width, map.height),
                                       CompletionKind::given};
  }
}

/// What is seen of the parts, the ink of their outlines with it, is theirs.
void add_rim(const PartRegions& seen, Completion& clipped) {
  for (int part = 0; part < seen.count(); ++part)
    clipped.parts[part].shape = united(clipped.parts[part].shape, seen.visible[part]);
}

/// By what c is multiplied: features lie on all parts that they are tied to and touch.
double inflation_factor(const Proposal& proposal, const Completion& clipped, int part) {
  if (touches_background(proposal.regions, part)) return 1;
  const auto touch = [&](int lower) {
    return std::any_of(proposal.evidence.begin(), proposal.evidence.end(), [&](const auto& pair) {
      return std::minmax(pair.a, pair.b) == std::minmax(part, lower);
    });
  };
  const auto area = [&](int k) { return static_cast<double>(pixel_count(clipped.parts[k].shape)); };
  double below = 0;
  for (const ProposedRelation& proposed : proposal.joining.relations) {
    const Relation& relation = proposed.relation;
    if (relation.upper == part && is_tie(relation.kind) && touch(relation.lower))
      below += area(relation.lower);
  }
  return below == 0 ? 1 : feature_inflation(area(part) / below);
}

/// For outlines as smooth as those that a hand draws on a canvas of this size.
OutlineOptions smooth_outlines(const Image16& map) {
  OutlineOptions options;
  const double scale = std::max(1.0, tremor_share * std::hypot(map.width, map.height));
  options.reach *= scale;
  options.wavelength *= scale;
  return options;
}

/// The outlines in the scene: as the user drew them, or those of the shapes after the order.
std::vector<Outline> scene_outlines(const Corrections& corrections, const PartRegions& regions,
                                    const Completion& clipped) {
  const OutlineOptions options = smooth_outlines(regions.map);
  std::vector<Outline> outlines;
  for (int part = 0; part < regions.count(); ++part) {
    const auto found = corrections.parts.find(regions.labels[part]);
    const bool given = found != corrections.parts.end() && found->second.outline;
    outlines.push_back(given ? *found->second.outline
                             : outline_of(clipped.parts[part].shape, options));
    orient_by_nesting(outlines.back());
  }
  return outlines;
}

/// Those of parts of which the user said none.
std::vector<ProposedLean> leans_without(const Corrections& corrections, const PartRegions& regions,
                                        std::vector<ProposedLean> leans) {
  const auto is_said = [&](const ProposedLean& proposed) {
    const auto found = corrections.parts.find(regions.labels[proposed.part]);
    return found != corrections.parts.end() && found->second.lean;
  };
  leans.erase(std::remove_if(leans.begin(), leans.end(), is_said), leans.end());
  return leans;
}

/// What was proposed for a part that leans.
Point2 proposed_lean(const Proposal& proposal, int part) {
  for (const ProposedLean& proposed : proposal.joining.leans)
    if (proposed.part == part)
      return {std::round(proposed.lean.x * 100) / 100, std::round(proposed.lean.y * 100) / 100};
  return {};
}

/// After its label, unless the user gave that name to another part.
std::string proposed_id(const Corrections& corrections, PartLabel label) {
  const auto is_said = [&](const std::string& id) {
    return std::any_of(corrections.parts.begin(), corrections.parts.end(),
                       [&](const auto& part) { return part.second.id == id; });
  };
  return free_name("part-" + std::to_string(label), is_said);
}

/// A part as proposed, but for what the user said of it.
Part corrected(const Corrections& corrections, PartLabel label, Part part) {
  const auto found = corrections.parts.find(label);
  const PartCorrection said = found == corrections.parts.end() ? PartCorrection{} : found->second;
  part.id = said.id ? *said.id : proposed_id(corrections, label);
  part.c = said.c.value_or(std::round(part.c * 100) / 100);
  part.d = said.d.value_or(1);
  part.flat = said.flat.value_or(part.flat);
  part.lean = said.lean.value_or(part.lean);
  return part;
}

/// `seen` are the regions with the ink of their outlines.
Scene scene_of(const Corrections& corrections, const Proposal& proposal, const PartRegions& seen,
               const Completion& clipped, const std::vector<Outline>& outlines) {
  const std::vector<int>& rank = proposal.stacking.rank;
  Scene scene;
  scene.width = proposal.regions.map.width;
  scene.height = proposal.regions.map.height;
  const std::vector<uint8_t> backdrops =
      find_backdrops(seen, proposal.stacking, clipped, proposal.joining.joins);
  for (const int part : proposal.stacking.back_to_front) {
    Part proposed;
    proposed.outline = outlines[part];
    proposed.c =
        round_inflation(clipped.parts[part].shape) * inflation_factor(proposal, clipped, part);
    proposed.lean = proposed_lean(proposal, part);
    if (backdrops[part] != 0) {
      proposed.c *= backdrop_inflation;
      proposed.flat = backdrop_flat;
    }
    scene.parts.push_back(
        corrected(corrections, proposal.regions.labels[part], std::move(proposed)));
  }
  const auto renumbered = [&](auto item) {
    item.upper = rank[item.upper];
    item.lower = rank[item.lower];
    return item;
  };
  for (const ProposedJoin& join : proposal.joining.joins)
    scene.joins.push_back(renumbered(join.join));
  for (const ProposedRelation& relation : proposal.joining.relations)
    scene.relations.push_back(renumbered(relation.relation));
  for (const RobinRange& range : proposal.joining.robin) scene.robin.push_back(renumbered(range));
  scene.cues = LabelResolver(proposal.regions).cues(corrections.cues);
  for (Cue& cue : scene.cues) cue.part = rank[cue.part];
  return scene;
}

Status check_labels(const PartRegions& regions, const Corrections& corrections, int max_parts) {
  if (regions.count() == 0)
    return Error{ErrorCode::bad_input, "has no parts: every pixel is background", "labels"};
  if (regions.count() > max_parts)
    return Error{ErrorCode::limit, "has more than " + std::to_string(max_parts) + " parts",
                 "labels"};
  for (const auto& [label, correction] : corrections.parts)
    if (regions.part_of(label) < 0) return no_such_label(label);
  return Done{};
}

/// Fills in what follows from the regions, stage by stage.
Status propose(Proposal& proposal, const Corrections& corrections, const ProposalOptions& options,
               const RunContext& context) {
  LabelResolver resolver(proposal.regions);
  const std::vector<UserArrow> arrows = resolver.arrows(corrections);
  resolver.cues(corrections.cues);
  if (resolver.error()) return *resolver.error();
  auto evidence = compare_neighbours(proposal.regions, options.completion, context);
  if (!evidence) return evidence.error();
  proposal.evidence = std::move(*evidence);
  for (NeighbourEvidence& pair : proposal.evidence) {
    const auto& open = options.joining.open;
    const std::pair<uint16_t, uint16_t> labels{proposal.regions.labels[pair.a],
                                               proposal.regions.labels[pair.b]};
    pair.open = std::binary_search(open.begin(), open.end(), labels);
  }
  auto stacking = stack_parts(proposal.regions, proposal.evidence, arrows);
  if (!stacking) return stacking.error();
  proposal.stacking = std::move(*stacking);
  auto completion = complete_parts(proposal.regions, possible_occluders(proposal, arrows), context);
  if (!completion) return completion.error();
  proposal.completion = std::move(*completion);
  keep_given_outlines(corrections, proposal);
  return Done{};
}

}  // namespace

Result<Proposal> propose_scene(const Image16& labels, const Corrections& corrections,
                               const ProposalOptions& options, const RunContext& context) {
  Proposal proposal;
  const Image16 seen = without_specks(labels, options.min_pixels, proposal.warnings);
  proposal.regions = find_regions(without_rim(seen, options.rim));
  if (Status s = check_labels(proposal.regions, corrections, options.max_parts); !s)
    return s.error();
  if (Status s = propose(proposal, corrections, options, context); !s) return s.error();
  auto clipped = shapes_in_order(proposal, context);
  if (!clipped) return clipped.error();
  std::optional<PartRegions> with_rim;
  if (options.rim > 0) add_rim(with_rim.emplace(find_regions(seen)), *clipped);
  const std::vector<Outline> outlines = scene_outlines(corrections, proposal.regions, *clipped);
  proposal.joining =
      propose_joins(proposal.regions, proposal.stacking, outlines,
                    LabelResolver(proposal.regions).joining(corrections.joining), options.joining);
  proposal.joining.leans =
      leans_without(corrections, proposal.regions,
                    propose_leans(proposal.regions, proposal.stacking, *clipped, proposal.joining));
  proposal.scene =
      scene_of(corrections, proposal, with_rim ? *with_rim : proposal.regions, *clipped, outlines);
  if (Status s = validate(proposal.scene); !s) return s.error();
  return proposal;
}

}  // namespace relievo::understanding
