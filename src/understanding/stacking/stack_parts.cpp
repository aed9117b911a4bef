#include "understanding/stacking/stack_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "kernel/base/cyclic_runs.h"
#include "kernel/base/exact_functions.h"
#include "kernel/image/outlines.h"
#include "understanding/stacking/order_graph.h"

namespace relievo::understanding {
namespace {

constexpr double bulge_scale = 0.06;  ///< A / C at which the confidence is 1 - 1/e
constexpr size_t min_sides = 8;       ///< shorter runs of a boundary are ignored

/// Sums over the runs of a common boundary.
struct Bulge {
  double area = 0;    ///< A: on the second part's side of the chords, px^2
  double chords = 0;  ///< C: squared lengths, px^2
};

/// Twice the area between a run of sides and its chord; positive where the ring's own part bulges
/// out.
double twice_area(const LabelRing& ring, size_t first, size_t count) {
  const Point2 origin = ring.sides[first % ring.size()];
  double sum = 0;
  for (size_t i = first; i + 1 < first + count; ++i)
    sum += cross(ring.sides[i % ring.size()] - origin, ring.sides[(i + 1) % ring.size()] - origin);
  return sum;
}

constexpr double least_confidence = 0.01;  ///< cues below are left out

/// Weights of the cues: the log-odds that a cue of 1 adds for its part. They are fitted by logistic
/// regression to pairs whose order is known (docs/understanding/stacking.md).
constexpr double shape_weight = 0.8;
constexpr double contour_weight = 3.2;
constexpr double junction_weight = 2;
constexpr double bulge_weight = 0.5;
constexpr double floor_weight = 0.4;
constexpr double front_weight = 1.9;
/// Regularises the shape cue: the width of a strip along the common boundary, px.
constexpr double strip_width = 1.5;
/// Regularises the junction cue: the sum of confidences of junctions that favour neither part.
constexpr double silent_junctions = 0.5;
/// Parts stand on the floor where they end in this lowest share of the figure's height.
constexpr double floor_share = 0.03;
/// Log-odds of two parts without a common boundary that the one that ends higher is in front, for a
/// difference of the figure's height: feet are behind.
constexpr double below_weight = 0.2;
/// Log-odds of the smaller of two parts that have grown together being in front, as a limb.
constexpr double open_odds = 4;
/// Log-odds of the user's arrows, more than all guesses together.
constexpr double user_odds = 1e6;
/// Bounds of a guess's confidence: more counts as the first, and guesses below the second are left
/// out.
constexpr double surest = 0.9999;
constexpr double min_arrow_confidence = 0.05;

/// The cues of a pair; signed ones are positive where the first part is in front.
struct PairBelief {
  double shape = 0;
  double contour = 0;
  double junctions[2] = {0, 0};  ///< sums of confidences for either part
  double bulge = 0;
  double floor = 0;
  double front = 0;
  double open = 0;  ///< 1 or -1 where the two have grown together; then no other cue counts

  /// Log-odds of the first part being in front.
  double log_odds() const {
    if (open != 0) return open_odds * open;
    const double votes = junctions[0] + junctions[1] + silent_junctions;
    return shape_weight * shape + contour_weight * contour + bulge_weight * bulge +
           junction_weight * (junctions[0] - junctions[1]) / votes + floor_weight * floor +
           front_weight * front;
  }
};

using Pair = std::pair<PartLabel, PartLabel>;

/// The rows, from the top, in which the figure begins and before which it ends.
std::pair<int, int> rows_of_figure(const PartRegions& regions) {
  int top = regions.map.height;
  int bottom = 0;
  for (const Mask& visible : regions.visible) {
    top = std::min(top, visible.top);
    bottom = std::max(bottom, visible.bottom());
  }
  return {top, bottom};
}

PairBelief belief_of(const PartRegions& regions, const NeighbourEvidence& pair) {
  const Mask& a = regions.visible[regions.part_of(pair.a)];
  const Mask& b = regions.visible[regions.part_of(pair.b)];
  const auto [top, bottom] = rows_of_figure(regions);
  const double lowest = floor_share * (bottom - top);
  const auto stands = [&, end = bottom](const Mask& m) {
    return end - m.bottom() < lowest ? 1 : 0;
  };
  PairBelief belief;
  belief.shape = (pair.b_below_a - pair.a_below_b) /
                 (pair.a_below_b + pair.b_below_a + strip_width * pair.shared);
  belief.contour = (pair.a_shaped ? 1 : 0) - (pair.b_shaped ? 1 : 0);
  belief.floor = stands(b) - stands(a);
  belief.front = pair.front;
  if (pair.open) belief.open = pixel_count(a) < pixel_count(b) ? 1 : -1;
  return belief;
}

std::map<Pair, PairBelief> collect(const PartRegions& regions,
                                   const std::vector<NeighbourEvidence>& evidence) {
  std::map<Pair, PairBelief> beliefs;
  for (const NeighbourEvidence& pair : evidence)
    beliefs[{pair.a, pair.b}] = belief_of(regions, pair);
  for (const OrderArrow& bulge : find_bulges(regions)) {
    const auto found = beliefs.find(std::minmax(bulge.upper, bulge.lower));
    if (found != beliefs.end())
      found->second.bulge = bulge.upper < bulge.lower ? bulge.confidence : -bulge.confidence;
  }
  for (const OrderArrow& cue : find_junction_cues(regions)) {
    const auto found = beliefs.find(std::minmax(cue.upper, cue.lower));
    if (found == beliefs.end()) continue;
    found->second.junctions[cue.upper < cue.lower ? 0 : 1] += cue.confidence;
  }
  return beliefs;
}

OrderArrow arrow_of(const Pair& pair, const PairBelief& belief) {
  const double log_odds = belief.log_odds();
  const auto [upper, lower] = log_odds >= 0 ? pair : Pair(pair.second, pair.first);
  // The difference between the probabilities p and 1 - p.
  return {upper, lower, 2 / (1 + exact::exp(-std::abs(log_odds))) - 1};
}

/// The user's arrows, and a guess for every other pair of which enough is known.
std::vector<OrderArrow> all_arrows(const std::map<Pair, PairBelief>& beliefs,
                                   const std::vector<Pair>& user) {
  std::vector<OrderArrow> arrows;
  std::set<Pair> ordered;
  for (const auto& [upper, lower] : user) {
    arrows.push_back({upper, lower, 1, true});
    ordered.insert(std::minmax(upper, lower));
  }
  for (const auto& [pair, belief] : beliefs) {
    const OrderArrow arrow = arrow_of(pair, belief);
    if (ordered.count(pair) == 0 && arrow.confidence >= min_arrow_confidence)
      arrows.push_back(arrow);
  }
  std::sort(arrows.begin(), arrows.end(), [](const OrderArrow& p, const OrderArrow& q) {
    return Pair(p.upper, p.lower) < Pair(q.upper, q.lower);
  });
  return arrows;
}

/// Per pair of parts, the log-odds of the first being in front.
std::vector<std::vector<double>> pair_odds(const PartRegions& regions,
                                           const std::vector<OrderArrow>& arrows) {
  const int parts = regions.count();
  const auto [top, bottom] = rows_of_figure(regions);
  std::vector<std::vector<double>> odds(parts, std::vector<double>(parts, 0));
  for (int a = 0; a < parts; ++a)
    for (int b = 0; b < parts; ++b)
      odds[a][b] = below_weight * (regions.visible[b].bottom() - regions.visible[a].bottom()) /
                   std::max(1, bottom - top);
  for (const OrderArrow& arrow : arrows) {
    const int upper = regions.part_of(arrow.upper);
    const int lower = regions.part_of(arrow.lower);
    const double sure = std::min(arrow.confidence, surest);
    odds[upper][lower] = arrow.user ? user_odds : exact::log((1 + sure) / (1 - sure));
    odds[lower][upper] = -odds[upper][lower];
  }
  return odds;
}

}  // namespace

std::vector<OrderArrow> find_bulges(const PartRegions& regions) {
  std::map<std::pair<PartLabel, PartLabel>, Bulge> bulges;
  for (const std::vector<LabelRing>& rings : regions.rings)
    for (const LabelRing& ring : rings) {
      const auto same = [&](size_t i, size_t j) { return ring.beyond[i] == ring.beyond[j]; };
      for_each_run(ring.size(), same, [&](size_t first, size_t count) {
        const PartLabel other = ring.beyond[first];
        if (other < ring.label || count < min_sides) return;
        const Point2 chord = ring.sides[(first + count - 1) % ring.size()] - ring.sides[first];
        Bulge& bulge = bulges[{ring.label, other}];
        bulge.area += twice_area(ring, first, count) / 2;
        bulge.chords += dot(chord, chord);
      });
    }
  std::vector<OrderArrow> arrows;
  for (const auto& [pair, bulge] : bulges) {
    if (bulge.area == 0) continue;
    const double confidence =
        1 - exact::exp(-std::abs(bulge.area) / (bulge_scale * std::max(bulge.chords, 1e-9)));
    const auto [first, second] = pair;
    if (bulge.area > 0)
      arrows.push_back({first, second, confidence});
    else
      arrows.push_back({second, first, confidence});
  }
  return arrows;
}

std::vector<OrderArrow> find_junction_cues(const PartRegions& regions) {
  std::vector<OrderArrow> cues;
  for (const std::vector<LabelRing>& rings : regions.rings)
    for (const LabelRing& ring : rings)
      for (const Junction& junction : find_junctions(ring)) {
        const double confidence = t_junction_confidence(junction);
        if (confidence < least_confidence) continue;
        for (const PartLabel beyond : {junction.before, junction.after})
          if (beyond != 0) cues.push_back({ring.label, beyond, confidence});
      }
  return cues;
}

Result<Stacking> stack_parts(const PartRegions& regions,
                             const std::vector<NeighbourEvidence>& evidence,
                             const std::vector<Pair>& user_arrows) {
  Stacking stacking;
  stacking.arrows = all_arrows(collect(regions, evidence), user_arrows);
  if (Status status = break_cycles(regions.labels, stacking.arrows); !status) return status.error();
  std::vector<double> area;
  for (const Mask& visible : regions.visible)
    area.push_back(static_cast<double>(pixel_count(visible)));
  const std::vector<int> order =
      likelier_order(sort_back_to_front(regions.labels, area, stacking.arrows),
                     pair_odds(regions, stacking.arrows));
  std::vector<size_t> rank(order.size());
  for (const int part : order) {
    rank[part] = stacking.back_to_front.size();
    stacking.back_to_front.push_back(regions.labels[part]);
  }
  for (OrderArrow& arrow : stacking.arrows)
    arrow.kept = rank[regions.part_of(arrow.upper)] > rank[regions.part_of(arrow.lower)];
  return stacking;
}

}  // namespace relievo::understanding
