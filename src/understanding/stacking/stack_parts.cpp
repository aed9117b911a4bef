#include "understanding/stacking/stack_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernel/base/exact_functions.h"
#include "understanding/stacking/bulges.h"
#include "understanding/stacking/junctions.h"
#include "understanding/stacking/order_graph.h"

namespace relievo::understanding {
namespace {

/// Log-odds of the model: what a cue that is sure adds for the part for which it speaks. Fitted
/// by logistic regression on pairs whose order is known (docs/understanding/stacking.md).
constexpr double shape_weight = 1.6;
constexpr double contour_weight = 2.5;
constexpr double junction_weight = 3.5;
constexpr double bulge_weight = 1.5;
constexpr double ground_weight = 1.2;
/// Gains below a strip of this width along the common boundary say nothing, px.
constexpr double strip_width = 1.5;
/// Junctions that say nothing of a pair, beside which those that do are weighed.
constexpr double silent_junctions = 0.5;
/// The lowest part of the figure's height, in which what stands on the ground ends.
constexpr double ground_share = 0.03;
/// Parts of which nothing else is known: the one that ends lower on the page is behind, as feet
/// are, with this log-odds for a difference of the figure's height.
constexpr double below_weight = 0.2;
/// Of two parts that have grown together the smaller one is the limb, and drawn in front.
constexpr double open_odds = 4;
/// What the user says outweighs all guesses.
constexpr double user_odds = 1e6;
constexpr double surest = 0.9999;  ///< confidence that counts
/// Guesses that are less sure say less than that the larger part is behind.
constexpr double min_arrow_confidence = 0.05;

/// What the cues say of a pair; signed ones are positive where the first part is in front.
struct PairBelief {
  double shape = 0;
  double contour = 0;
  double junctions[2] = {0, 0};  ///< sums of confidences for either part
  double bulge = 0;
  double ground = 0;
  double open = 0;  ///< 1 or -1 where the two have grown together, and nothing else counts

  /// Of the first part being in front.
  double log_odds() const {
    if (open != 0) return open_odds * open;
    const double votes = junctions[0] + junctions[1] + silent_junctions;
    return shape_weight * shape + contour_weight * contour + bulge_weight * bulge +
           junction_weight * (junctions[0] - junctions[1]) / votes + ground_weight * ground;
  }
};

using Pair = std::pair<int, int>;
using Beliefs = std::map<Pair, PairBelief>;

/// Per part, whether it reaches down to where the figure ends.
std::vector<uint8_t> on_the_ground(const PartRegions& regions) {
  int top = regions.map.height;
  int bottom = 0;
  for (const Mask& visible : regions.visible) {
    top = std::min(top, visible.top);
    bottom = std::max(bottom, visible.bottom());
  }
  std::vector<uint8_t> stands;
  for (const Mask& visible : regions.visible)
    stands.push_back(bottom - visible.bottom() < ground_share * (bottom - top) ? 1 : 0);
  return stands;
}

PairBelief belief_of(const NeighbourEvidence& evidence, const std::vector<uint8_t>& stands) {
  PairBelief belief;
  belief.shape = (evidence.b_below_a - evidence.a_below_b) /
                 (evidence.a_below_b + evidence.b_below_a + strip_width * evidence.shared);
  belief.contour = (evidence.a_shaped ? 1 : 0) - (evidence.b_shaped ? 1 : 0);
  belief.ground = stands[evidence.b] - stands[evidence.a];
  return belief;
}

Beliefs collect(const PartRegions& regions, const std::vector<NeighbourEvidence>& evidence) {
  const std::vector<uint8_t> stands = on_the_ground(regions);
  Beliefs beliefs;
  for (const NeighbourEvidence& pair : evidence) {
    PairBelief& belief = beliefs[{pair.a, pair.b}] = belief_of(pair, stands);
    const auto seen = [&](int part) { return pixel_count(regions.visible[part]); };
    if (pair.open) belief.open = seen(pair.a) < seen(pair.b) ? 1 : -1;
  }
  for (const BulgeCue& cue : find_bulge_cues(regions)) {
    const Pair pair = std::minmax(cue.upper, cue.lower);
    const auto found = beliefs.find(pair);
    if (found != beliefs.end())
      found->second.bulge = cue.upper == pair.first ? cue.confidence : -cue.confidence;
  }
  for (const JunctionCue& cue : find_junction_cues(regions)) {
    const Pair pair = std::minmax(cue.upper, cue.lower);
    const auto found = beliefs.find(pair);
    if (found != beliefs.end())
      found->second.junctions[cue.upper == pair.first ? 0 : 1] += cue.confidence;
  }
  return beliefs;
}

OrderArrow arrow_of(const Pair& pair, const PairBelief& belief) {
  const double log_odds = belief.log_odds();
  OrderArrow arrow;
  arrow.upper = log_odds >= 0 ? pair.first : pair.second;
  arrow.lower = log_odds >= 0 ? pair.second : pair.first;
  // Of probabilities p and 1 - p, the difference.
  arrow.confidence = 2 / (1 + exact::exp(-std::abs(log_odds))) - 1;
  return arrow;
}

/// Whether the user ordered these two parts.
bool is_said(const std::vector<UserArrow>& user, const Pair& pair) {
  return std::any_of(user.begin(), user.end(), [&](const UserArrow& arrow) {
    return Pair(std::minmax(arrow.first, arrow.second)) == pair;
  });
}

std::vector<OrderArrow> guesses(const Beliefs& beliefs, const std::vector<UserArrow>& user) {
  std::vector<OrderArrow> arrows;
  for (const auto& [upper, lower] : user)
    arrows.push_back({upper, lower, 1, OrderSource::user, true});
  for (const auto& [pair, belief] : beliefs) {
    const OrderArrow arrow = arrow_of(pair, belief);
    if (!is_said(user, pair) && arrow.confidence >= min_arrow_confidence) arrows.push_back(arrow);
  }
  std::sort(arrows.begin(), arrows.end(), [](const OrderArrow& p, const OrderArrow& q) {
    return std::pair(p.upper, p.lower) < std::pair(q.upper, q.lower);
  });
  return arrows;
}

/// Of every two parts, the log-odds of the first being in front.
std::vector<std::vector<double>> pair_odds(const PartRegions& regions,
                                           const std::vector<OrderArrow>& arrows) {
  const int parts = regions.count();
  int top = regions.map.height;
  int bottom = 0;
  for (const Mask& visible : regions.visible) {
    top = std::min(top, visible.top);
    bottom = std::max(bottom, visible.bottom());
  }
  std::vector<std::vector<double>> odds(parts, std::vector<double>(parts, 0));
  for (int a = 0; a < parts; ++a)
    for (int b = 0; b < parts; ++b)
      odds[a][b] = below_weight * (regions.visible[b].bottom() - regions.visible[a].bottom()) /
                   std::max(1, bottom - top);
  for (const OrderArrow& arrow : arrows) {
    const double sure = std::min(arrow.confidence, surest);
    const double said = exact::log((1 + sure) / (1 - sure));
    odds[arrow.upper][arrow.lower] = arrow.source == OrderSource::user ? user_odds : said;
    odds[arrow.lower][arrow.upper] = -odds[arrow.upper][arrow.lower];
  }
  return odds;
}

}  // namespace

Result<Stacking> stack_parts(const PartRegions& regions,
                             const std::vector<NeighbourEvidence>& evidence,
                             const std::vector<UserArrow>& user_arrows) {
  Stacking stacking;
  stacking.arrows = guesses(collect(regions, evidence), user_arrows);
  if (Status status = break_cycles(regions.count(), stacking.arrows); !status)
    return status.error();
  std::vector<double> area;
  for (const Mask& visible : regions.visible)
    area.push_back(static_cast<double>(pixel_count(visible)));
  stacking.back_to_front = likelier_order(sort_back_to_front(area, stacking.arrows),
                                          pair_odds(regions, stacking.arrows));
  stacking.rank.resize(area.size());
  for (size_t i = 0; i < area.size(); ++i)
    stacking.rank[stacking.back_to_front[i]] = static_cast<int>(i);
  for (OrderArrow& arrow : stacking.arrows)
    arrow.kept = stacking.rank[arrow.upper] > stacking.rank[arrow.lower];
  return stacking;
}

}  // namespace relievo::understanding
