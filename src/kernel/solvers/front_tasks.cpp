#include "kernel/solvers/front_tasks.h"

#include <algorithm>

namespace relievo {
namespace {

/// Of all arithmetic, in one task.
constexpr double largest_share = 1.0 / 16;
/// Multiplications that are not worth a thread of their own.
constexpr double least_shared_work = 2e6;

/// Multiplications of the elimination of each front.
std::vector<double> work_of_fronts(const Supernodes& fronts) {
  std::vector<double> work;
  work.reserve(fronts.parent.size());
  for (int s = 0; s < fronts.size(); ++s) {
    double sum = 0;
    for (int c = 0; c < fronts.columns(s); ++c) {
      const double below = fronts.rows(s) - c;
      sum += 0.5 * below * below;
    }
    work.push_back(sum);
  }
  return work;
}

/// Fronts, whose parents are among them, by the length of the longest way down from each.
std::vector<std::vector<int>> levels_of(const std::vector<int>& top, const Supernodes& fronts) {
  std::vector<std::vector<int>> levels;
  std::vector<size_t> level(fronts.parent.size(), 0);
  for (const int s : top) {
    if (level[s] == levels.size()) levels.emplace_back();
    levels[level[s]].push_back(s);
    if (const int parent = fronts.parent[s]; parent >= 0)
      level[parent] = std::max(level[parent], level[s] + 1);
  }
  return levels;
}

}  // namespace

FrontTasks split_into_tasks(const Supernodes& fronts) {
  std::vector<double> subtree = work_of_fronts(fronts);
  double total = 0;
  for (const double work : subtree) total += work;
  for (int s = 0; s < fronts.size(); ++s)
    if (fronts.parent[s] >= 0) subtree[fronts.parent[s]] += subtree[s];
  const double limit = total < least_shared_work ? total : largest_share * total;

  FrontTasks result;
  result.top_place.assign(fronts.order.size(), -1);
  double gathered = 0;
  bool open = false;
  for (int s = 0; s < fronts.size(); ++s) {
    if (subtree[s] > limit) {
      result.top.push_back(s);
      for (int c = fronts.column_begin[s]; c < fronts.column_begin[s + 1]; ++c)
        result.top_place[c] = result.top_columns++;
      open = false;
      continue;
    }
    if (!open) result.tasks.push_back({s, s});
    if (!open) gathered = 0;
    result.tasks.back().last = s + 1;
    const bool root = fronts.parent[s] < 0 || subtree[fronts.parent[s]] > limit;
    if (root) gathered += subtree[s];
    open = !root || gathered < 0.5 * limit;
  }
  result.top_levels = levels_of(result.top, fronts);
  return result;
}

}  // namespace relievo
