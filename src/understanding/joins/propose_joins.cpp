#include "understanding/joins/propose_joins.h"

#include <algorithm>
#include <array>
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

using Pair = std::pair<PartLabel, PartLabel>;

constexpr double min_root = 0.1;       ///< least share of the upper outline that a root takes
constexpr int min_root_sides = 8;      ///< least length of a root, pixel sides
constexpr double max_size_ratio = 10;  ///< of the visible upper part to the visible lower
/// Bounds of the share of a root that the ramp at each end of its join takes.
constexpr double shortest_ramp = 0.08;
constexpr double longest_ramp = 0.3;
/// Colours that differ by less may be shades of one, and those that differ by more are others;
/// Euclidean distance, 255 a channel.
constexpr double same_colour = 40;
constexpr double other_colour = 100;
/// The largest loose piece that is attached to another, as a share of that.
constexpr double loose_share = 0.25;
constexpr double line_step = 3;  ///< distance of the points of a join's line, px
/// The largest length of a root's arc on the outline, per pixel side.
constexpr double max_stretch = 1.5;
/// The least share of a join that lies inside the lower part.
constexpr double min_inside = 0.5;
/// Least confidence of an arrow between parts of which one rises above the other.
constexpr double sure_order = 0.2;

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

/// The line of the arc without a ramp at each end.
std::vector<Point2> line_of(const RootArc& arc, double ramp) {
  const double length = arc.length - 2 * ramp;
  const int pieces = std::max(8, static_cast<int>(length / line_step));
  std::vector<Point2> line;
  for (int i = 0; i <= pieces; ++i) line.push_back(arc.at(ramp + length * i / pieces));
  return line;
}

/// The longest run of points inside the outline; empty where that is less than this share of all.
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

/// The connections that the completed outlines show (see propose_layer_joins).
JoinProposals connect_whole(const PartRegions& regions, const std::vector<Outline>& outlines,
                            const std::vector<std::array<double, 3>>& colours) {
  Scene scene;
  scene.width = regions.map.width;
  scene.height = regions.map.height;
  PartColors colors;
  for (int part = 0; part < regions.count(); ++part) {
    scene.parts.push_back({"", outlines[part]});
    if (regions.labels[part] >= colours.size()) continue;
    const std::array<double, 3>& c = colours[regions.labels[part]];
    colors.push_back({{c[0] / 255, c[1] / 255, c[2] / 255}});
  }
  if (colors.size() < scene.parts.size()) colors.clear();
  return propose_layer_joins(scene, colors);
}

class JoinProposer {
 public:
  JoinProposer(const PartRegions& regions, const std::vector<Outline>& outlines,
               const std::vector<OrderArrow>& order, const Corrections& corrections,
               const DrawingEvidence& evidence)
      : regions_(regions), outlines_(outlines), evidence_(evidence) {
    for (const OrderArrow& arrow : order)
      if (arrow.kept && arrow.confidence >= sure_order)
        sure_.insert(Pair(arrow.upper, arrow.lower));
    for (const Join& join : corrections.joins) {
      joined_.insert(Pair(join.upper, join.lower));
      out_.joins.push_back({indexed(join), 1, true});
      fixed_.insert(out_.joins.back().join.upper);
    }
    unjoined_.insert(corrections.no_joins.begin(), corrections.no_joins.end());
    for (const Relation& relation : corrections.relations) {
      related_.insert(Pair(relation.upper, relation.lower));
      out_.relations.push_back({indexed(relation), true});
    }
    for (const RobinRange& range : corrections.robin) {
      ramped_.insert(Pair(range.upper, range.lower));
      out_.robin.push_back(indexed(range));
    }
  }

  JoinProposals run() {
    const std::vector<int> parts = regions_.by_label();
    for (const int part : parts) grow_open(part);
    const JoinProposals whole = connect_whole(regions_, outlines_, evidence_.colours);
    grow_limbs(whole.joins);
    for (const auto& [tie, user, confidence] : whole.relations) {
      tied_.insert({pair_of(tie.upper, tie.lower), tie.kind});
      if (tie.kind == RelationKind::joined && !is_decided(pair_of(tie.upper, tie.lower)))
        behind_[tie.lower] = confidence;
    }
    for (const int part : parts) propose(part);
    for (const auto& [pair, kind] : tied_)
      propose_relation(regions_.part_of(pair.first), regions_.part_of(pair.second), kind);
    attach_loose();
    return std::move(out_);
  }

 private:
  Pair pair_of(int upper, int lower) const {
    return {regions_.labels[upper], regions_.labels[lower]};
  }

  /// A correction with indices in place of labels.
  template <class Item>
  Item indexed(Item item) const {
    item.upper = regions_.part_of(static_cast<PartLabel>(item.upper));
    item.lower = regions_.part_of(static_cast<PartLabel>(item.lower));
    return item;
  }

  bool is_decided(const Pair& pair) const {
    return joined_.count(pair) + unjoined_.count(pair) + related_.count(pair) > 0;
  }

  /// Takes over the joins of limbs whose completed outlines show where they grow out of one body,
  /// which their borders need not show.
  void grow_limbs(const std::vector<ProposedJoin>& joins) {
    for (const ProposedJoin& proposed : joins) {
      const int upper = proposed.join.upper;
      const Pair pair = pair_of(upper, proposed.join.lower);
      if (is_decided(pair) || fixed_.count(upper) > 0) continue;
      joined_.insert(pair);
      limbs_.insert(upper);
      out_.joins.push_back(proposed);
    }
  }

  /// Joins a part to those behind it with which it has grown together.
  void grow_open(int part) {
    for (const Root& root : surroundings(regions_, part).roots) {
      const Pair pair = pair_of(part, root.lower);
      if (is_decided(pair) || fixed_.count(part) > 0 || !evidence_.is_open(pair.first, pair.second))
        continue;
      if (root.count < static_cast<size_t>(min_root_sides)) continue;
      if (lay_join(part, root, 1)) fixed_.insert(part);
    }
  }

  void propose(int part) {
    const Surroundings around = surroundings(regions_, part);
    for (const Root& root : around.roots) propose_join(part, root, around);
    for (const int lower : around.lower) {
      const auto tie = tied_.find(pair_of(part, lower));
      const bool rises = !around.enclosed && sure_.count(pair_of(part, lower)) > 0;
      const RelationKind apart = rises ? RelationKind::above : RelationKind::equal;
      propose_relation(part, lower, tie != tied_.end() ? tie->second : apart);
    }
  }

  void propose_join(int part, const Root& root, const Surroundings& around) {
    const auto same = [&](const Root& other) { return other.lower == root.lower; };
    const bool only = std::count_if(around.roots.begin(), around.roots.end(), same) == 1;
    if (around.enclosed || !only || is_decided(pair_of(part, root.lower)) || limbs_.count(part) > 0)
      return;
    const double length = static_cast<double>(root.count);
    const double share = length / static_cast<double>(root.ring->size());
    if (share < min_root || root.count < static_cast<size_t>(min_root_sides)) return;
    if (is_far_larger(part, root.lower)) return;
    const double confidence = colour_trust(part, root.lower) * std::min(1.0, 0.5 + share);
    const auto behind = behind_.find(part);
    if (behind == behind_.end() || behind->second <= confidence) lay_join(part, root, confidence);
  }

  bool is_far_larger(int part, int lower) const {
    const auto seen = [&](int k) { return static_cast<double>(pixel_count(regions_.visible[k])); };
    return seen(part) > max_size_ratio * seen(lower);
  }

  /// From 1 for parts of one colour to one half for parts of clearly different colours.
  double colour_trust(int part, int lower) const {
    const size_t a = regions_.labels[part];
    const size_t b = regions_.labels[lower];
    if (std::max(a, b) >= evidence_.colours.size()) return 1;
    double squares = 0;
    for (size_t c = 0; c < 3; ++c) {
      const double difference = evidence_.colours[a][c] - evidence_.colours[b][c];
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
    joined_.insert(pair_of(part, root.lower));
    if (ramped_.count(pair_of(part, root.lower)) == 0) {
      if (root.opens_before) lay_ramp(part, root.lower, line.front(), arc->at(0));
      if (root.opens_after) lay_ramp(part, root.lower, line.back(), arc->at(arc->length));
    }
    out_.joins.push_back({{part, root.lower, line}, confidence, false});
    return true;
  }

  void lay_ramp(int upper, int lower, Point2 from, Point2 to) {
    out_.robin.push_back({upper, lower, from, to, std::nullopt, std::nullopt});
  }

  /// The share of the root that each ramp takes: three quarters of half the excess over the chord,
  /// so that a limb's join is its cap.
  double ramp_share(const RootArc& arc) const {
    const double chord = distance(arc.at(0), arc.at(arc.length));
    const double share = 0.75 * (arc.length - chord) / (2 * arc.length);
    return std::clamp(share, shortest_ramp, longest_ramp);
  }

  void propose_relation(int upper, int lower, RelationKind kind) {
    const Pair pair = pair_of(upper, lower);
    if (joined_.count(pair) > 0 || !related_.insert(pair).second) return;
    out_.relations.push_back({{upper, lower, kind, std::nullopt}, false});
  }

  /// Lets each small loose piece grow out from behind the part that it borders on
  /// most, since it would come off where the model is turned.
  void attach_loose() {
    DisjointSets attached(regions_.count());
    for (const ProposedJoin& proposed : out_.joins)
      attached.unite(proposed.join.upper, proposed.join.lower);
    std::vector<std::map<int, int>> sides;
    for (int part = 0; part < regions_.count(); ++part)
      sides.push_back(shared_sides(regions_, part));
    std::vector<std::pair<int, size_t>> loose;  // sides, index of the relation
    for (size_t i = 0; i < out_.relations.size(); ++i) {
      const auto& [relation, user, confidence] = out_.relations[i];
      if (is_tie(relation.kind)) attached.unite(relation.upper, relation.lower);
      if (!user && !is_tie(relation.kind) &&
          unjoined_.count(pair_of(relation.upper, relation.lower)) == 0)
        loose.emplace_back(sides[relation.lower][relation.upper], i);
    }
    std::vector<int64_t> seen(regions_.count(), 0);
    for (int part = 0; part < regions_.count(); ++part)
      seen[attached.find(part)] += pixel_count(regions_.visible[part]);
    std::sort(loose.begin(), loose.end(), std::greater<>());
    for (const auto& [shared, i] : loose) {
      if (shared < min_root_sides) break;
      Relation& relation = out_.relations[i].relation;
      const int upper = attached.find(relation.upper);
      const int lower = attached.find(relation.lower);
      if (upper == lower ||
          static_cast<double>(seen[lower]) > loose_share * static_cast<double>(seen[upper]))
        continue;
      relation.kind = RelationKind::joined;
      attached.unite(upper, lower);
      seen[std::min(upper, lower)] = seen[upper] + seen[lower];
    }
  }

  const PartRegions& regions_;
  const std::vector<Outline>& outlines_;
  const DrawingEvidence& evidence_;
  std::set<Pair> sure_;  ///< an upper part and the lower one above which it rises
  std::set<int> fixed_;  ///< parts that the user joined, or that have grown together
  std::set<int> limbs_;  ///< parts that grow out of another by their completed outlines
  /// Limbs that grow out from behind another part, and the confidence of that.
  std::map<int, double> behind_;
  std::map<Pair, RelationKind> tied_;  ///< by completed outlines
  std::set<Pair> joined_;
  std::set<Pair> unjoined_;  ///< by the user
  std::set<Pair> related_;
  std::set<Pair> ramped_;  ///< with Robin ranges of the user
  JoinProposals out_;
};

}  // namespace

JoinProposals propose_joins(const PartRegions& regions, const std::vector<Outline>& outlines,
                            const std::vector<OrderArrow>& order, const Corrections& corrections,
                            const DrawingEvidence& evidence) {
  return JoinProposer(regions, outlines, order, corrections, evidence).run();
}

}  // namespace relievo::understanding
