#pragma once

#include <vector>

#include "kernel/solvers/supernodes.h"

namespace relievo {

/// Consecutive fronts [first, last), whole subtrees, that depend on no others.
struct FrontTask {
  int first = 0;
  int last = 0;
};

/// Independent pieces of a factorisation and the fronts that wait for all of them.
struct FrontTasks {
  std::vector<FrontTask> tasks;  ///< ascending
  std::vector<int> top;          ///< fronts in no task, ascending
  /// The same, each after those of its children that are among them: all of a level are
  /// independent.
  std::vector<std::vector<int>> top_levels;
  std::vector<int> top_place;  ///< #n: number of a top front's column among those, or -1
  int top_columns = 0;
};

/// Cuts the tree of fronts so that no task has more than a small share of the arithmetic, unless
/// all of it is little: that is one task. O(S + n).
FrontTasks split_into_tasks(const Supernodes& fronts);

}  // namespace relievo
