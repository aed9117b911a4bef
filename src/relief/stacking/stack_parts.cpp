#include "relief/stacking/stack_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "relief/stacking/junctions.h"
#include "relief/stacking/order_graph.h"

namespace relievo {
namespace {

/// How much the gains of area are trusted: the probability that a score of 1 tells the truth.
constexpr double shape_trust = 0.9;
/// Gains below this share of the smaller part, or of a strip of this width along the common
/// boundary, say nothing.
constexpr double strip_width = 1.5;
constexpr double min_confidence = 0.02;

/// Probabilities that the first part of a pair is in front, and that the second one is.
struct PairBelief {
  double shape[2] = {0, 0};
  double junction[2] = {0, 0};
};

using Beliefs = std::map<std::pair<int, int>, PairBelief>;

double unite(double p, double q) { return 1 - (1 - p) * (1 - q); }

Beliefs collect(const PartRegions& regions, const std::vector<MutualGain>& gains) {
  Beliefs beliefs;
  for (const MutualGain& gain : gains) {
    const double noise = strip_width * gain.shared;
    const double score =
        (gain.b_below_a - gain.a_below_b) / (gain.a_below_b + gain.b_below_a + noise);
    PairBelief& belief = beliefs[{gain.a, gain.b}];
    belief.shape[score > 0 ? 0 : 1] = shape_trust * std::abs(score);
  }
  for (const JunctionCue& cue : find_junction_cues(regions)) {
    const auto pair = std::minmax(cue.upper, cue.lower);
    const auto found = beliefs.find(pair);
    if (found == beliefs.end()) continue;
    double& p = found->second.junction[cue.upper == pair.first ? 0 : 1];
    p = unite(p, cue.confidence);
  }
  return beliefs;
}

OrderArrow arrow_of(const std::pair<int, int>& pair, const PairBelief& belief) {
  const double first = unite(belief.shape[0], belief.junction[0]);
  const double second = unite(belief.shape[1], belief.junction[1]);
  const int front = first >= second ? 0 : 1;
  OrderArrow arrow;
  arrow.upper = front == 0 ? pair.first : pair.second;
  arrow.lower = front == 0 ? pair.second : pair.first;
  arrow.confidence = std::abs(first - second);
  const bool shape = belief.shape[front] > 0;
  const bool junction = belief.junction[front] > 0;
  if (junction) arrow.source = shape ? OrderSource::both : OrderSource::junction;
  return arrow;
}

std::vector<OrderArrow> guesses(const Beliefs& beliefs, const std::vector<UserArrow>& user) {
  std::vector<OrderArrow> arrows;
  for (const auto& [upper, lower] : user)
    arrows.push_back({upper, lower, 1, OrderSource::user, true});
  for (const auto& [pair, belief] : beliefs) {
    const OrderArrow arrow = arrow_of(pair, belief);
    const bool said = std::any_of(user.begin(), user.end(), [&](const UserArrow& u) {
      return std::minmax(u.first, u.second) == std::minmax(pair.first, pair.second);
    });
    if (!said && arrow.confidence >= min_confidence) arrows.push_back(arrow);
  }
  std::sort(arrows.begin(), arrows.end(), [](const OrderArrow& p, const OrderArrow& q) {
    return std::pair(p.upper, p.lower) < std::pair(q.upper, q.lower);
  });
  return arrows;
}

}  // namespace

Result<Stacking> stack_parts(const PartRegions& regions, const std::vector<MutualGain>& gains,
                             const std::vector<UserArrow>& user_arrows) {
  Stacking stacking;
  stacking.arrows = guesses(collect(regions, gains), user_arrows);
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
