#include "relief/model/edge_cuts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "relief/model/rim_levels.h"

namespace relievo {
namespace {

constexpr int64_t max_triangles = int64_t{1} << 24;

/// The vertices at both ends of an edge, in its direction.
std::array<int, 2> edge_ends(const SheetSurface& surface, int edge) {
  const FaceEdge owner = surface.edge_owner[edge];
  return {surface.vertex[corner_of(owner.face, next_place(owner.corner))],
          surface.vertex[corner_of(owner.face, last_place(owner.corner))]};
}

std::vector<double> vertex_levels(const SheetSurface& surface, const Inflation& inflation,
                                  const RimLevels& levels) {
  std::vector<double> level(surface.vertex_node.size());
  for (size_t v = 0; v < level.size(); ++v)
    level[v] = levels.level(inflation.u[surface.vertex_node[v]]);
  return level;
}

std::vector<int> cut_counts(const SheetSurface& surface, const std::vector<double>& level) {
  std::vector<int> count(surface.edge_owner.size());
  for (size_t e = 0; e < count.size(); ++e) {
    const auto [a, b] = edge_ends(surface, static_cast<int>(e));
    count[e] = cut_count(level[a], level[b]);
  }
  return count;
}

/// Every cut on an edge of a face makes one more triangle of it.
struct PieceCount {
  int64_t total = 0;
  int64_t worst = 0;  ///< of one face
};

PieceCount count_pieces(const SheetSurface& surface, const std::vector<int>& cuts) {
  PieceCount pieces;
  for (size_t f = 0; f < surface.edge.size(); f += 3) {
    if (surface.edge[f] < 0) continue;
    int64_t count = 1;
    for (size_t k = 0; k < 3; ++k) count += cuts[surface.edge[f + k]];
    pieces.total += count;
    pieces.worst = std::max(pieces.worst, count);
  }
  return pieces;
}

double position_of_level(const RimLevels& levels, double level, double u_first, double u_last) {
  const double f = levels.height(level);
  return std::clamp((f * std::abs(f) - u_first) / (u_last - u_first), 0.0, 1.0);
}

void place_cuts(const SheetSurface& surface, const Inflation& inflation, const RimLevels& levels,
                EdgeCuts& cuts) {
  for (size_t e = 0; e < surface.edge_owner.size(); ++e) {
    const auto [a, b] = edge_ends(surface, static_cast<int>(e));
    const double u_first = inflation.u[surface.vertex_node[a]];
    const double u_last = inflation.u[surface.vertex_node[b]];
    for (int i = cuts.begin[e]; i < cuts.begin[e + 1]; ++i) {
      cuts.level[i] = cut_level(cuts.vertex_level[a], cuts.vertex_level[b], i - cuts.begin[e]);
      cuts.t[i] = position_of_level(levels, cuts.level[i], u_first, u_last);
    }
  }
}

}  // namespace

Result<EdgeCuts> cut_edges(const SheetSurface& surface, const Inflation& inflation,
                           const ModelOptions& options) {
  const int64_t max_pieces = int64_t{1} << (2 * options.max_rim_levels);
  double tolerance = options.rim_tolerance;
  EdgeCuts cuts;
  std::vector<int> count;
  PieceCount pieces;
  for (;; tolerance *= 2) {
    cuts.vertex_level = vertex_levels(surface, inflation, RimLevels(tolerance));
    count = cut_counts(surface, cuts.vertex_level);
    pieces = count_pieces(surface, count);
    if (pieces.worst <= max_pieces) break;
  }
  if (pieces.total > max_triangles)
    return Error{ErrorCode::limit,
                 "the surface would have " + std::to_string(pieces.total) +
                     " triangles, more than " + std::to_string(max_triangles),
                 "rim_tolerance"};
  cuts.begin.assign(count.size() + 1, 0);
  for (size_t e = 0; e < count.size(); ++e) cuts.begin[e + 1] = cuts.begin[e] + count[e];
  int next = cuts.begin.back();
  for (size_t e = 0; e < count.size(); ++e) {
    const bool creased = surface.edge_twin[e].face >= 0;
    cuts.twin.push_back(creased ? next : -1);
    next += creased ? count[e] : 0;
  }
  cuts.level.resize(cuts.begin.back());
  cuts.t.resize(cuts.begin.back());
  place_cuts(surface, inflation, RimLevels(tolerance), cuts);
  return cuts;
}

}  // namespace relievo
