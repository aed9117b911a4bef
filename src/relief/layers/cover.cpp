#include "relief/layers/cover.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "kernel/base/disjoint_sets.h"
#include "kernel/geometry/polygon.h"

namespace relievo::relief {
namespace {

/// Loops of one part along an undirected edge: crossing it from left to right of (low -> high)
/// adds `turn` to the winding number of `part`.
struct EdgeTurn {
  std::array<int, 2> edge;
  int part;
  int turn;
};

using Winding = std::vector<std::pair<int, int>>;  // part, number; ascending parts, no zeros

std::vector<EdgeTurn> collect_turns(const SheetMesh& mesh) {
  std::vector<EdgeTurn> turns;
  for (size_t l = 0; l < mesh.loops.size(); ++l) {
    const std::vector<int>& loop = mesh.loops[l];
    for (size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      // The left side of a -> b has the larger winding number.
      turns.push_back({{std::min(a, b), std::max(a, b)}, mesh.loop_part[l], a < b ? -1 : 1});
    }
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

/// The turns along the edge opposite to corner k.
std::span<const EdgeTurn> turns_at(const std::vector<EdgeTurn>& turns, const Triangle& triangle,
                                   int k) {
  const auto [low, high] = std::minmax(triangle[next_place(k)], triangle[last_place(k)]);
  const auto [first, last] =
      std::equal_range(turns.begin(), turns.end(), EdgeTurn{{low, high}, 0, 0},
                       [](const EdgeTurn& x, const EdgeTurn& y) { return x.edge < y.edge; });
  return {turns.data() + (first - turns.begin()), static_cast<size_t>(last - first)};
}

/// Adds turns, times a sign, to winding numbers.
Winding crossed(Winding winding, std::span<const EdgeTurn> turns, int sign) {
  for (const EdgeTurn& turn : turns) {
    if (turn.turn == 0) continue;
    const auto at =
        std::lower_bound(winding.begin(), winding.end(), turn.part,
                         [](const auto& entry, int part) { return entry.first < part; });
    if (at != winding.end() && at->first == turn.part) {
      at->second += sign * turn.turn;
      if (at->second == 0) winding.erase(at);
    } else {
      winding.insert(at, {turn.part, sign * turn.turn});
    }
  }
  return winding;
}

/// The sign of turns when a triangle is left through the edge opposite to corner k.
int sign_out(const Triangle& triangle, int k) {
  return triangle[next_place(k)] < triangle[last_place(k)] ? 1 : -1;
}

/// Winding numbers of all triangles: `region` (#T) gives the index of a triangle's in the result.
std::vector<Winding> flood(const SheetMesh& mesh, std::vector<int>& region) {
  const std::vector<EdgeTurn> turns = collect_turns(mesh);
  std::vector<Winding> windings;
  std::vector<int> pending;
  const auto start_region = [&](int t, Winding winding) {
    region[t] = static_cast<int>(windings.size());
    windings.push_back(std::move(winding));
    pending.push_back(t);
  };
  for (size_t seed = 0; seed < region.size(); ++seed)
    for (int side = 0; side < 3; ++side) {
      if (mesh.base.neighbours[seed][side] >= 0 || region[seed] >= 0) continue;
      const Triangle& hull = mesh.base.triangles[seed];
      start_region(static_cast<int>(seed),
                   crossed({}, turns_at(turns, hull, side), -sign_out(hull, side)));
      while (!pending.empty()) {
        const int t = pending.back();
        pending.pop_back();
        for (int k = 0; k < 3; ++k) {
          const int next = mesh.base.neighbours[t][k];
          if (next < 0 || region[next] >= 0) continue;
          const Triangle& triangle = mesh.base.triangles[t];
          const std::span<const EdgeTurn> along = turns_at(turns, triangle, k);
          if (along.empty()) {
            region[next] = region[t];
            pending.push_back(next);
          } else {
            start_region(next, crossed(windings[region[t]], along, sign_out(triangle, k)));
          }
        }
      }
    }
  return windings;
}

}  // namespace

void cover_triangles(SheetMesh& mesh) {
  std::vector<int> region(mesh.base.triangles.size(), -1);
  const std::vector<Winding> windings = flood(mesh, region);
  mesh.stack_begin.push_back(0);
  for (size_t t = 0; t < region.size(); ++t) {
    for (const auto& entry : windings[region[t]]) {
      mesh.face_part.push_back(entry.first);
      mesh.face_triangle.push_back(static_cast<int>(t));
    }
    mesh.stack_begin.push_back(static_cast<int>(mesh.face_part.size()));
  }
  mesh.face_source = mesh.face_part;
  mesh.faces.resize(mesh.face_part.size());
}

void drop_specks(double least_area, SheetMesh& mesh) {
  const int faces = static_cast<int>(mesh.face_part.size());
  DisjointSets pieces(faces);
  for (int f = 0; f < faces; ++f)
    for (const int next : mesh.base.neighbours[mesh.face_triangle[f]]) {
      if (next < mesh.face_triangle[f]) continue;
      const int other = mesh.face_of(next, mesh.face_part[f]);
      if (other >= 0) pieces.unite(f, other);
    }
  std::vector<double> area(faces, 0);
  for (int f = 0; f < faces; ++f) {
    const auto [a, b, c] = mesh.base.triangles[mesh.face_triangle[f]];
    const Point2 p = mesh.points[a];
    area[pieces.find(f)] += 0.5 * cross(mesh.points[b] - p, mesh.points[c] - p);
  }
  std::vector<uint8_t> dropped(faces);
  for (int f = 0; f < faces; ++f) dropped[f] = area[pieces.find(f)] >= least_area ? 0 : 1;
  drop_faces(dropped, mesh);
}

}  // namespace relievo::relief
