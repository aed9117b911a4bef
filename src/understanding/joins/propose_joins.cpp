#include "understanding/joins/propose_joins.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "kernel/base/disjoint_sets.h"
#include "kernel/geometry/polygon.h"
#include "understanding/joins/propose_layer_joins.h"
#include "understanding/joins/roots.h"

namespace relievo::understanding {
namespace {

using Pair = std::pair<int, int>;

/// Colours that differ by less, of 255 a channel, may be shades; by more, they are others.
constexpr double same_colour = 40;
constexpr double other_colour = 100;
/// Of what may hold it, that a piece may be which nothing holds.
constexpr double loose_share = 0.25;
constexpr double line_step = 3;  ///< between the points of a join's line, px
/// A root's arc on the outline is at most so many times as long as its pixel sides.
constexpr double max_stretch = 1.5;
/// At least this share of a join lies inside the lower part.
constexpr double min_inside = 0.5;

/// A root as an arc of the part's outline.
struct RootArc {
  const Ring* ring = nullptr;
  RingMeasure measure;
  double from = 0;    ///< arc length where it begins
  double length = 0;  ///< in the direction of the ring

  Point2 at(double s) const {
    return point_at(*ring, measure, from + std::clamp(s, 0.0, length) + measure.length);
  }
};

std::optional<RootArc> arc_of(const Root& root, const Outline& outline) {
  const Ring& sides = root.ring->sides;
  const Point2 first = sides[root.first];
  const Point2 last = sides[(root.first + root.count - 1) % sides.size()];
  std::optional<RootArc> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Ring& ring : outline) {
    RootArc arc{&ring, measure(ring), 0, 0};
    const RingFoot from = nearest_on_ring(ring, arc.measure, first);
    const RingFoot to = nearest_on_ring(ring, arc.measure, last);
    if (from.distance + to.distance >= nearest) continue;
    nearest = from.distance + to.distance;
    arc.from = from.s;
    arc.length = to.s >= from.s ? to.s - from.s : to.s - from.s + arc.measure.length;
    best = arc;
  }
  const bool sound =
      best && best->length > 0 && best->length <= max_stretch * static_cast<double>(root.count);
  return sound ? best : std::nullopt;
}

/// The arc without a ramp at each end.
std::vector<Point2> line_of(const RootArc& arc, double ramp) {
  const double length = arc.length - 2 * ramp;
  const int pieces = std::max(8, static_cast<int>(length / line_step));
  std::vector<Point2> line;
  for (int i = 0; i <= pieces; ++i) line.push_back(arc.at(ramp + length * i / pieces));
  return line;
}

/// The longest run of points inside the outline; empty where that is less than a share of all.
std::vector<Point2> longest_inside(const std::vector<Point2>& line, const Outline& outline,
                                   double least_share) {
  std::vector<Point2> best;
  std::vector<Point2> run;
  for (const Point2 p : line) {
    if (contains(outline, p))
      run.push_back(p);
    else
      run.clear();
    if (run.size() > best.size()) best = run;
  }
  const double share = static_cast<double>(best.size()) / static_cast<double>(line.size());
  return share >= least_share ? best : std::vector<Point2>();
}

/// What the whole outlines tell (see propose_layer_joins), by part.
JoinProposals connect_whole(const PartRegions& regions, const Stacking& stacking,
                            const std::vector<Outline>& outlines,
                            const JoinProposalOptions& options) {
  const std::vector<int>& part_at = stacking.back_to_front;
  Scene scene;
  scene.width = regions.map.width;
  scene.height = regions.map.height;
  PartColors colors;
  for (const int part : part_at) {
    scene.parts.push_back({"", outlines[part]});
    if (regions.labels[part] >= options.colours.size()) continue;
    const std::array<double, 3>& c = options.colours[regions.labels[part]];
    colors.push_back({{c[0] / 255, c[1] / 255, c[2] / 255}});
  }
  if (colors.size() < scene.parts.size()) colors.clear();
  JoinProposals joining = propose_layer_joins(scene, colors);
  const auto renumber = [&](auto& item) {
    item.upper = part_at[item.upper];
    item.lower = part_at[item.lower];
  };
  for (ProposedJoin& proposed : joining.joins) renumber(proposed.join);
  for (ProposedRelation& proposed : joining.relations) renumber(proposed.relation);
  return joining;
}

class JoinProposer {
 public:
  JoinProposer(const PartRegions& regions, const Stacking& stacking,
               const std::vector<Outline>& outlines, const JoinCorrections& corrections,
               const JoinProposalOptions& options)
      : regions_(regions), stacking_(stacking), outlines_(outlines), options_(options) {
    for (const Join& join : corrections.joins) add_user(join);
    for (const Pair& pair : corrections.no_joins) unjoined_.insert(pair);
    for (const Relation& relation : corrections.relations) {
      out_.relations.push_back({relation, true});
      related_.insert({relation.upper, relation.lower});
    }
    out_.robin = corrections.robin;
    for (const RobinRange& range : corrections.robin) ramped_.insert({range.upper, range.lower});
  }

  JoinProposals run() {
    for (int part = 0; part < regions_.count(); ++part) grow_open(part);
    const JoinProposals whole = connect_whole(regions_, stacking_, outlines_, options_);
    grow_limbs(whole.joins);
    for (const ProposedRelation& proposed : whole.relations) {
      const Relation& tie = proposed.relation;
      const Pair pair{tie.upper, tie.lower};
      tied_.insert({pair, tie.kind});
      if (tie.kind == RelationKind::joined && !is_decided(pair))
        behind_[tie.lower] = proposed.confidence;
    }
    for (int part = 0; part < regions_.count(); ++part) propose(part);
    for (const auto& [pair, kind] : tied_) propose_relation(pair, kind);
    hold_loose();
    return std::move(out_);
  }

 private:
  void add_user(const Join& join) {
    out_.joins.push_back({join, 1, true});
    joined_.insert({join.upper, join.lower});
    said_.insert(join.upper);
  }

  bool is_decided(const Pair& pair) const {
    return joined_.count(pair) + unjoined_.count(pair) + related_.count(pair) > 0;
  }

  /// Limbs whose outlines show where they grow out of one body, which their borders need not.
  void grow_limbs(const std::vector<ProposedJoin>& joins) {
    for (const ProposedJoin& proposed : joins) {
      const Pair pair{proposed.join.upper, proposed.join.lower};
      if (is_decided(pair) || said_.count(pair.first) > 0) continue;
      joined_.insert(pair);
      limbs_.insert(pair.first);
      out_.joins.push_back(proposed);
    }
  }

  /// Where the drawing shows nothing between a part and one behind it.
  void grow_open(int part) {
    for (const Root& root : surroundings(regions_, stacking_, part).roots) {
      const Pair pair{part, root.lower};
      if (is_decided(pair) || said_.count(part) > 0 || !is_open(pair)) continue;
      if (root.count < static_cast<size_t>(options_.min_root_sides)) continue;
      if (lay_join(part, root, 1)) said_.insert(part);
    }
  }

  bool is_open(const Pair& pair) const {
    const uint16_t a = regions_.labels[pair.first];
    const uint16_t b = regions_.labels[pair.second];
    return std::binary_search(options_.open.begin(), options_.open.end(),
                              std::pair<uint16_t, uint16_t>(std::minmax(a, b)));
  }

  void propose(int part) {
    const Surroundings around = surroundings(regions_, stacking_, part);
    for (const Root& root : around.roots) propose_join(part, root, around);
    for (const int lower : around.lower) {
      const auto tie = tied_.find({part, lower});
      const RelationKind apart = around.enclosed ? RelationKind::equal : RelationKind::above;
      propose_relation({part, lower}, tie != tied_.end() ? tie->second : apart);
    }
  }

  void propose_join(int part, const Root& root, const Surroundings& around) {
    const auto same = [&](const Root& other) { return other.lower == root.lower; };
    const bool only = std::count_if(around.roots.begin(), around.roots.end(), same) == 1;
    const Pair pair{part, root.lower};
    if (around.enclosed || !only || is_decided(pair) || limbs_.count(part) > 0) return;
    const double length = static_cast<double>(root.count);
    const double share = length / static_cast<double>(root.ring->size());
    if (share < options_.min_root || root.count < static_cast<size_t>(options_.min_root_sides))
      return;
    if (is_far_larger(part, root.lower)) return;
    const double confidence = colour_trust(part, root.lower) * std::min(1.0, 0.5 + share);
    const auto behind = behind_.find(part);
    if (behind == behind_.end() || behind->second <= confidence) lay_join(part, root, confidence);
  }

  bool is_far_larger(int part, int lower) const {
    const auto seen = [&](int k) { return static_cast<double>(pixel_count(regions_.visible[k])); };
    return seen(part) > options_.max_size_ratio * seen(lower);
  }

  /// From 1 for parts of one colour to one half for those of clearly different ones.
  double colour_trust(int part, int lower) const {
    const size_t a = regions_.labels[part];
    const size_t b = regions_.labels[lower];
    if (std::max(a, b) >= options_.colours.size()) return 1;
    double squares = 0;
    for (size_t c = 0; c < 3; ++c) {
      const double difference = options_.colours[a][c] - options_.colours[b][c];
      squares += difference * difference;
    }
    const double change = (std::sqrt(squares) - same_colour) / (other_colour - same_colour);
    return 1 - 0.5 * std::clamp(change, 0.0, 1.0);
  }

  bool lay_join(int part, const Root& root, double confidence) {
    const auto arc = arc_of(root, outlines_[part]);
    if (!arc) return false;
    const double ramp = ramp_share(*arc) * arc->length;
    const std::vector<Point2> line =
        longest_inside(line_of(*arc, ramp), outlines_[root.lower], min_inside);
    if (line.empty()) return false;
    joined_.insert({part, root.lower});
    if (ramped_.count({part, root.lower}) == 0) {
      if (root.opens_before) lay_ramp(part, root.lower, line.front(), arc->at(0));
      if (root.opens_after) lay_ramp(part, root.lower, line.back(), arc->at(arc->length));
    }
    out_.joins.push_back({{part, root.lower, line}, confidence, false});
    return true;
  }

  void lay_ramp(int upper, int lower, Point2 from, Point2 to) {
    out_.robin.push_back({upper, lower, from, to, std::nullopt, std::nullopt});
  }

  /// Share of the root beside each end of the join: half of what exceeds the chord, and a little
  /// less, so that a limb's join is its cap.
  double ramp_share(const RootArc& arc) const {
    const double chord = distance(arc.at(0), arc.at(arc.length));
    const double share = 0.75 * (arc.length - chord) / (2 * arc.length);
    return std::clamp(share, options_.shortest_ramp, options_.longest_ramp);
  }

  void propose_relation(const Pair& pair, RelationKind kind) {
    if (joined_.count(pair) > 0 || !related_.insert(pair).second) return;
    out_.relations.push_back({{pair.first, pair.second, kind, std::nullopt}, false});
  }

  /// What nothing holds grows out from behind what it borders on most: it would come off where the
  /// model is turned.
  void hold_loose() {
    DisjointSets held(regions_.count());
    for (const ProposedJoin& proposed : out_.joins)
      held.unite(proposed.join.upper, proposed.join.lower);
    std::vector<std::map<int, int>> sides;
    for (int part = 0; part < regions_.count(); ++part)
      sides.push_back(shared_sides(regions_, part));
    std::vector<std::pair<int, size_t>> loose;  // sides, index of the relation
    for (size_t i = 0; i < out_.relations.size(); ++i) {
      const auto& [relation, user, confidence] = out_.relations[i];
      if (is_tie(relation.kind)) held.unite(relation.upper, relation.lower);
      const Pair pair{relation.upper, relation.lower};
      if (!user && !is_tie(relation.kind) && unjoined_.count(pair) == 0)
        loose.emplace_back(sides[pair.second][pair.first], i);
    }
    std::vector<int64_t> seen(regions_.count(), 0);
    for (int part = 0; part < regions_.count(); ++part)
      seen[held.find(part)] += pixel_count(regions_.visible[part]);
    std::sort(loose.begin(), loose.end(), std::greater<>());
    for (const auto& [shared, i] : loose) {
      if (shared < options_.min_root_sides) break;
      Relation& relation = out_.relations[i].relation;
      const int upper = held.find(relation.upper);
      const int lower = held.find(relation.lower);
      if (upper == lower ||
          static_cast<double>(seen[lower]) > loose_share * static_cast<double>(seen[upper]))
        continue;
      relation.kind = RelationKind::joined;
      held.unite(upper, lower);
      seen[std::min(upper, lower)] = seen[upper] + seen[lower];
    }
  }

  const PartRegions& regions_;
  const Stacking& stacking_;
  const std::vector<Outline>& outlines_;
  const JoinProposalOptions& options_;
  std::set<int> said_;   ///< parts that the user joined to something
  std::set<int> limbs_;  ///< parts that grow out of another as their whole outlines tell
  /// Limbs that grow out from behind another part, and how sure that is.
  std::map<int, double> behind_;
  std::map<Pair, RelationKind> tied_;  ///< as whole outlines tell
  std::set<Pair> joined_;
  std::set<Pair> unjoined_;
  std::set<Pair> related_;
  std::set<Pair> ramped_;
  JoinProposals out_;
};

}  // namespace

JoinProposals propose_joins(const PartRegions& regions, const Stacking& stacking,
                            const std::vector<Outline>& outlines,
                            const JoinCorrections& corrections,
                            const JoinProposalOptions& options) {
  return JoinProposer(regions, stacking, outlines, corrections, options).run();
}

}  // namespace relievo::understanding
