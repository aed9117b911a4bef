#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "support/random_limbs.h"
#include "understanding/joins/join_proposals.h"

namespace relievo::testing {

/// A disc with parts of given outlines in front of it, or the first of them behind it.
inline Scene disc_with(const std::vector<Ring>& front, const std::vector<Ring>& behind = {}) {
  Scene scene = canvas();
  for (const Ring& ring : behind)
    scene.parts.push_back(part("b" + std::to_string(scene.parts.size()), ring));
  scene.parts.push_back(part("body", circle({200, 160}, 90)));
  for (const Ring& ring : front)
    scene.parts.push_back(part("f" + std::to_string(scene.parts.size()), ring));
  return scene;
}

inline Ring limb(double half_width = 22) { return capsule({200, 200}, M_PI / 2, 150, half_width); }

inline bool is_equal(const understanding::JoinProposals& joining, int upper, int lower,
                     RelationKind kind = RelationKind::equal) {
  return std::any_of(joining.relations.begin(), joining.relations.end(), [&](const auto& proposed) {
    const Relation& relation = proposed.relation;
    return relation.upper == upper && relation.lower == lower && relation.kind == kind;
  });
}

}  // namespace relievo::testing
