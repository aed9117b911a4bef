#include "understanding/scene/connect_scene.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "kernel/image/outlines.h"
#include "understanding/joins/part_profile.h"
#include "understanding/joins/propose_layer_joins.h"

namespace relievo::understanding {
namespace {

/// c of parts that look hollow, which makes a shallow dish of them.
constexpr double hollow_amount = 1;

double area_of(Part part) {
  orient_by_nesting(part.outline);
  return area(part.outline);
}

/// Ties limbs in place of joining them. A limb is tied once to parts that the author joined, since
/// they are one surface.
void tie_limbs(const Scene& scene, JoinProposals& guesses) {
  const auto are_joined = [&](int a, int b) {
    return std::any_of(scene.joins.begin(), scene.joins.end(), [&](const Join& join) {
      return std::minmax(join.upper, join.lower) == std::minmax(a, b);
    });
  };
  for (const ProposedJoin& guess : guesses.joins) {
    const int limb = guess.join.upper;
    const int body = guess.join.lower;
    std::erase_if(guesses.relations, [&](const ProposedRelation& tie) {
      return tie.relation.upper == limb && are_joined(tie.relation.lower, body);
    });
    guesses.relations.push_back({{limb, body, RelationKind::equal, std::nullopt}, false});
  }
  guesses.joins.clear();
  for (ProposedRelation& guess : guesses.relations) guess.relation.kind = RelationKind::equal;
}

/// Drops guesses about parts that the author connected. Where the author connected any, limbs are
/// tied in place of being joined.
void yield_to_author(const Scene& scene, JoinProposals& guesses) {
  std::set<std::pair<int, int>> pairs;  // upper, lower
  std::set<int> placed;                 // parts of which the author says what they lie on
  const auto note = [&](int upper, int lower, int part) {
    pairs.insert({upper, lower});
    placed.insert(part);
  };
  for (const Join& join : scene.joins) note(join.upper, join.lower, join.upper);
  for (const RobinRange& range : scene.robin) note(range.upper, range.lower, range.upper);
  for (const Relation& relation : scene.relations) {
    const bool behind = relation.kind == RelationKind::joined;
    note(relation.upper, relation.lower, behind ? relation.lower : relation.upper);
  }
  std::erase_if(guesses.joins,
                [&](const ProposedJoin& guess) { return placed.count(guess.join.upper) > 0; });
  std::erase_if(guesses.relations, [&](const ProposedRelation& guess) {
    const Relation& tie = guess.relation;
    const bool behind = area_of(scene.parts[tie.lower]) < area_of(scene.parts[tie.upper]);
    return pairs.count({tie.upper, tie.lower}) > 0 ||
           placed.count(behind ? tie.lower : tie.upper) > 0;
  });
  if (!placed.empty()) tie_limbs(scene, guesses);
}

}  // namespace

ConnectedScene connect_scene(Scene scene, bool amounts, const PartColors& colors,
                             const std::vector<Point2>& anchors) {
  ConnectedScene connected{std::move(scene), {}};
  Scene& result = connected.scene;
  if (amounts)
    for (Part& part : result.parts) {
      const Mask mask = fill_outline(part.outline, static_cast<int>(std::ceil(result.width)),
                                     static_cast<int>(std::ceil(result.height)));
      part.c = std::round(round_inflation(mask) * 100) / 100;
    }
  connected.proposals = propose_layer_joins(result, colors, anchors);
  yield_to_author(result, connected.proposals);
  for (const auto& [part, share] : connected.proposals.features)
    if (amounts)
      result.parts[part].c =
          std::round(result.parts[part].c * feature_inflation(share) * 100) / 100;
  for (const ProposedJoin& proposed : connected.proposals.joins)
    result.joins.push_back(proposed.join);
  for (const int part : connected.proposals.hollows)
    if (amounts) {
      result.parts[part].c = hollow_amount;
      result.parts[part].d = -1;
    }
  for (const ProposedRelation& proposed : connected.proposals.relations)
    result.relations.push_back(proposed.relation);
  return connected;
}

}  // namespace relievo::understanding
