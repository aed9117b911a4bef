#pragma once

#include <array>
#include <utility>
#include <vector>

#include "relievo/scene.h"

namespace relievo::understanding {

/// Per part, its colours, the main one first, channels in [0, 1].
using PartColors = std::vector<std::vector<std::array<double, 3>>>;

/// A join that was proposed, or given by the user.
struct ProposedJoin {
  Join join;
  double confidence = 0;  ///< in [0, 1]; 1 for the user's
  bool user = false;
};

/// A relation that was proposed, or given by the user.
struct ProposedRelation {
  Relation relation;
  bool user = false;
  double confidence = 0;  ///< in [0, 1]; known of `joined` only
};

/// A proposed tilt of a part (Part::lean).
struct ProposedLean {
  int part = -1;
  Point2 lean;
  double confidence = 0;  ///< in [0, 1]
};

/// How the parts of a scene connect. All indices are those of the scene's parts.
struct JoinProposals {
  std::vector<ProposedJoin> joins;
  std::vector<ProposedRelation> relations;
  std::vector<RobinRange> robin;
  std::vector<ProposedLean> leans;  ///< of parts whose tilt the user did not give
  std::vector<int> hollows;         ///< layers that look like open mouths or ear cups
  /// Small compact layers inside others, as eyes are, and their share of the smallest of those.
  std::vector<std::pair<int, double>> features;
};

}  // namespace relievo::understanding
