#include "relief/pipeline/connect_scene.h"

#include <cmath>
#include <utility>

#include "kernel/image/fill_outline.h"
#include "relief/joining/connect_parts.h"
#include "relief/joining/round_inflation.h"

namespace relievo {

namespace {

/// A dish, not a hole.
constexpr double hollow_amount = 1;

bool says_connections(const Scene& scene) {
  return !scene.joins.empty() || !scene.relations.empty() || !scene.robin.empty();
}

}  // namespace

ConnectedScene connect_scene(Scene scene, bool amounts, const PartColors& colors) {
  ConnectedScene connected{std::move(scene), {}};
  Scene& result = connected.scene;
  if (amounts)
    for (Part& part : result.parts) {
      const Mask mask = fill_outline(part.outline, static_cast<int>(std::ceil(result.width)),
                                     static_cast<int>(std::ceil(result.height)));
      part.c = std::round(round_inflation(mask) * 100) / 100;
    }
  if (says_connections(result)) return connected;
  connected.proposals = connect_parts(result, colors);
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

}  // namespace relievo
