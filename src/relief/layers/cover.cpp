#include "relief/layers/cover.h"

#include <algorithm>
#include <array>
#include <utility>

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

/// Loops along one undirected edge: crossing it from left to right of (low -> high) adds `turn`
/// to the winding number of `part`.
struct EdgeTurn {
  std::array<int, 2> edge;
  int part;
  int turn;
};

using Winding = std::vector<std::pair<int, int>>;  // part, number; ascending parts, no zeros

std::vector<EdgeTurn> collect_turns(const std::vector<std::vector<int>>& loops,
                                    const std::vector<int>& loop_part) {
  std::vector<EdgeTurn> turns;
  for (size_t l = 0; l < loops.size(); ++l)
    for (size_t i = 0; i < loops[l].size(); ++i) {
      const int a = loops[l][i];
      const int b = loops[l][(i + 1) % loops[l].size()];
      // The left side of a -> b has the larger winding number.
      turns.push_back({{std::min(a, b), std::max(a, b)}, loop_part[l], a < b ? -1 : 1});
    }
  std::sort(turns.begin(), turns.end(), [](const EdgeTurn& x, const EdgeTurn& y) {
    return x.edge != y.edge ? x.edge < y.edge : x.part < y.part;
  });
  std::vector<EdgeTurn> merged;
  for (const EdgeTurn& turn : turns) {
    if (!merged.empty() && merged.back().edge == turn.edge && merged.back().part == turn.part)
      merged.back().turn += turn.turn;
    else
      merged.push_back(turn);
  }
  return merged;
}

class Flood {
 public:
  Flood(const PlanarTriangulation& base, std::vector<EdgeTurn> turns)
      : base_(base), turns_(std::move(turns)), region_(base.triangles.size(), -1) {}

  Cover run() {
    for (size_t t = 0; t < base_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (base_.neighbours[t][k] < 0 && region_[t] < 0)
          enter(static_cast<int>(t), crossed(Winding(), static_cast<int>(t), k, true));
    Cover cover;
    cover.stack_begin.push_back(0);
    for (const int region : region_) {
      for (const auto& entry : winding_[region]) cover.stack_part.push_back(entry.first);
      cover.stack_begin.push_back(static_cast<int>(cover.stack_part.size()));
    }
    return cover;
  }

 private:
  std::pair<const EdgeTurn*, const EdgeTurn*> turns_at(int t, int k) const {
    const std::array<int, 3>& corners = base_.triangles[t];
    const int a = corners[(k + 1) % 3];
    const int b = corners[(k + 2) % 3];
    const std::array<int, 2> key = {std::min(a, b), std::max(a, b)};
    const auto range =
        std::equal_range(turns_.begin(), turns_.end(), EdgeTurn{key, 0, 0},
                         [](const EdgeTurn& x, const EdgeTurn& y) { return x.edge < y.edge; });
    return {turns_.data() + (range.first - turns_.begin()),
            turns_.data() + (range.second - turns_.begin())};
  }

  // Winding numbers across edge k of triangle t, going out of it, or into it.
  Winding crossed(Winding winding, int t, int k, bool inwards) const {
    const std::array<int, 3>& corners = base_.triangles[t];
    const bool low_to_high = corners[(k + 1) % 3] < corners[(k + 2) % 3];
    const int sign = low_to_high != inwards ? 1 : -1;
    const auto [first, last] = turns_at(t, k);
    for (const EdgeTurn* turn = first; turn != last; ++turn) {
      if (turn->turn == 0) continue;
      const auto at =
          std::lower_bound(winding.begin(), winding.end(), std::pair(turn->part, -(1 << 30)));
      if (at != winding.end() && at->first == turn->part) {
        at->second += sign * turn->turn;
        if (at->second == 0) winding.erase(at);
      } else {
        winding.insert(at, {turn->part, sign * turn->turn});
      }
    }
    return winding;
  }

  // Fills the region of a triangle and those around it, without recursion.
  void enter(int seed, Winding winding) {
    std::vector<int> pending = {start_region(seed, std::move(winding))};
    while (!pending.empty()) {
      const int t = pending.back();
      pending.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int next = base_.neighbours[t][k];
        if (next < 0 || region_[next] >= 0) continue;
        const auto [first, last] = turns_at(t, k);
        if (first == last)
          region_[next] = region_[t];
        else
          start_region(next, crossed(winding_[region_[t]], t, k, false));
        pending.push_back(next);
      }
    }
  }

  int start_region(int t, Winding winding) {
    region_[t] = static_cast<int>(winding_.size());
    winding_.push_back(std::move(winding));
    return t;
  }

  const PlanarTriangulation& base_;
  std::vector<EdgeTurn> turns_;
  std::vector<int> region_;
  std::vector<Winding> winding_;
};

}  // namespace

Cover cover_triangles(const PlanarTriangulation& base, const std::vector<std::vector<int>>& loops,
                      const std::vector<int>& loop_part) {
  return Flood(base, collect_turns(loops, loop_part)).run();
}

void drop_specks(const PlanarTriangulation& base, const std::vector<Point2>& points, double least,
                 Cover& cover) {
  const int triangles = static_cast<int>(base.triangles.size());
  const auto stack = [&cover](int t) {
    return std::pair(cover.stack_part.begin() + cover.stack_begin[t],
                     cover.stack_part.begin() + cover.stack_begin[t + 1]);
  };
  DisjointSets pieces(static_cast<int>(cover.stack_part.size()));
  for (int t = 0; t < triangles; ++t)
    for (const int next : base.neighbours[t]) {
      if (next < t) continue;
      const auto [first, last] = stack(next);
      for (int f = cover.stack_begin[t]; f < cover.stack_begin[t + 1]; ++f) {
        const auto at = std::lower_bound(first, last, cover.stack_part[f]);
        if (at != last && *at == cover.stack_part[f])
          pieces.unite(f, static_cast<int>(at - cover.stack_part.begin()));
      }
    }
  std::vector<double> area(cover.stack_part.size(), 0);
  for (int t = 0; t < triangles; ++t) {
    const auto [a, b, c] = base.triangles[t];
    for (int f = cover.stack_begin[t]; f < cover.stack_begin[t + 1]; ++f)
      area[pieces.find(f)] += 0.5 * cross(points[b] - points[a], points[c] - points[a]);
  }
  Cover kept{{0}, {}};
  for (int t = 0; t < triangles; ++t) {
    for (int f = cover.stack_begin[t]; f < cover.stack_begin[t + 1]; ++f)
      if (area[pieces.find(f)] >= least) kept.stack_part.push_back(cover.stack_part[f]);
    kept.stack_begin.push_back(static_cast<int>(kept.stack_part.size()));
  }
  cover = std::move(kept);
}

}  // namespace relievo::relief
