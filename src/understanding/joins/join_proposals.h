#pragma once

#include <array>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"

namespace relievo::understanding {

/// Of each part, its colours, the main one first, channels in [0, 1].
using PartColors = std::vector<std::vector<std::array<double, 3>>>;

/// A proposed join and how sure it is.
struct ProposedJoin {
  Join join;
  double confidence = 0;  ///< in [0, 1]; 1 for the user's
  bool user = false;
};

/// A proposed relation and whose it is.
struct ProposedRelation {
  Relation relation;
  bool user = false;
  double confidence = 0;  ///< in [0, 1], of `joined`
};

/// A proposed lean of a part.
struct ProposedLean {
  int part = -1;
  Point2 lean;
  double confidence = 0;  ///< in [0, 1]
};

/// How the parts connect. Indices are those of the parts in the order of their labels.
struct JoinProposals {
  std::vector<ProposedJoin> joins;
  std::vector<ProposedRelation> relations;
  std::vector<RobinRange> robin;
  std::vector<ProposedLean> leans;  ///< of parts of which the user said none
  std::vector<int> hollows;         ///< parts of layers that look like open mouths and ear cups
  /// Small compact parts of layers that lie within others, as eyes, and their share of the
  /// smallest.
  std::vector<std::pair<int, double>> features;
};

/// What the user said about how parts connect, by part index. It replaces every proposal for the
/// same two parts.
struct JoinCorrections {
  std::vector<Join> joins;
  std::vector<std::pair<int, int>> no_joins;  ///< upper, lower
  std::vector<Relation> relations;
  std::vector<RobinRange> robin;
};

}  // namespace relievo::understanding
