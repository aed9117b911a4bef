#include "relief/stacking/stack_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "relief/stacking/bulges.h"
#include "relief/stacking/junctions.h"
#include "relief/stacking/order_graph.h"

namespace relievo {
namespace {

/// How far the cues of shape are trusted.
constexpr double gain_trust = 0.9;
constexpr double contour_trust = 0.7;
constexpr double bulge_trust = 0.8;
/// Gains below a strip of this width along the common boundary say nothing, px.
constexpr double strip_width = 1.5;
constexpr double min_arrow_confidence = 0.02;

/// Probabilities by cue that the first part of a pair is in front, and that the second one is.
struct PairBelief {
  double shape[2] = {0, 0};
  double contour[2] = {0, 0};
  double junction[2] = {0, 0};
  double bulge[2] = {0, 0};

  double total(int side) const {
    return 1 - (1 - shape[side]) * (1 - contour[side]) * (1 - junction[side]) * (1 - bulge[side]);
  }
};

using Pair = std::pair<int, int>;
using Beliefs = std::map<Pair, PairBelief>;

double unite(double p, double q) { return 1 - (1 - p) * (1 - q); }

PairBelief belief_of(const NeighbourEvidence& evidence) {
  const double score = (evidence.b_below_a - evidence.a_below_b) /
                       (evidence.a_below_b + evidence.b_below_a + strip_width * evidence.shared);
  PairBelief belief;
  belief.shape[score > 0 ? 0 : 1] = gain_trust * std::abs(score);
  if (evidence.a_shaped != evidence.b_shaped)
    belief.contour[evidence.a_shaped ? 0 : 1] = contour_trust;
  return belief;
}

Beliefs collect(const PartRegions& regions, const std::vector<NeighbourEvidence>& evidence) {
  Beliefs beliefs;
  for (const NeighbourEvidence& pair : evidence) beliefs[{pair.a, pair.b}] = belief_of(pair);
  for (const BulgeCue& cue : find_bulge_cues(regions)) {
    const Pair pair = std::minmax(cue.upper, cue.lower);
    const auto found = beliefs.find(pair);
    if (found != beliefs.end())
      found->second.bulge[cue.upper == pair.first ? 0 : 1] = bulge_trust * cue.confidence;
  }
  for (const JunctionCue& cue : find_junction_cues(regions)) {
    const Pair pair = std::minmax(cue.upper, cue.lower);
    const auto found = beliefs.find(pair);
    if (found == beliefs.end()) continue;
    double& p = found->second.junction[cue.upper == pair.first ? 0 : 1];
    p = unite(p, cue.confidence);
  }
  return beliefs;
}

OrderArrow arrow_of(const Pair& pair, const PairBelief& belief) {
  const int front = belief.total(0) >= belief.total(1) ? 0 : 1;
  OrderArrow arrow;
  arrow.upper = front == 0 ? pair.first : pair.second;
  arrow.lower = front == 0 ? pair.second : pair.first;
  arrow.confidence = belief.total(front) - belief.total(1 - front);
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
  stacking.back_to_front = sort_back_to_front(area, stacking.arrows);
  stacking.rank.resize(area.size());
  for (size_t i = 0; i < area.size(); ++i)
    stacking.rank[stacking.back_to_front[i]] = static_cast<int>(i);
  return stacking;
}

}  // namespace relievo
