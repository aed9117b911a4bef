#include "relief/surface/cut_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace relievo::relief {
namespace {

/// Returns the corners of a face by rising level.
std::array<int, 3> rising_corners(const CutSurface& surface, int face) {
  std::array<int, 3> corners{0, 1, 2};
  std::stable_sort(corners.begin(), corners.end(), [&surface, face](int a, int b) {
    const std::vector<double>& level = surface.cuts.vertex_level;
    const std::vector<int>& vertex = surface.sheets.vertex;
    return level[vertex[corner_of(face, a)]] < level[vertex[corner_of(face, b)]];
  });
  return corners;
}

class FaceCutter {
 public:
  FaceCutter(const CutSurface& surface, double hidden_depth, ModelBuilder& builder)
      : surface_(surface), builder_(builder), hidden_depth_(hidden_depth) {}

  void cut(int face) {
    const int part = surface_.solved.mesh.face_part[face];
    const bool hidden = is_hidden(face);
    if (is_whole(face)) {
      const int* v = &surface_.sheets.vertex[corner_of(face, 0)];
      builder_.add_triangle(part, hidden, v[0], v[2], v[1]);
      return;
    }
    const auto [low, middle, high] = rising_corners(surface_, face);
    left_.clear();
    right_.clear();
    append(face, low, high, left_);
    append(face, low, middle, right_);
    right_.pop_back();
    append(face, middle, high, right_);
    const bool even = middle == next_place(low);
    zip([&](int a, int b, int next) {
      if (a == b || next == a || next == b) return;
      builder_.add_triangle(part, hidden, a, even ? next : b, even ? b : next);
    });
  }

 private:
  /// Returns whether a face lies clearly below the front one. If the two all but touch, the lower
  /// one keeps the drawing's colours, so that it does not matter which of them a viewer shows.
  bool is_hidden(int face) const {
    const LayeredMesh& mesh = surface_.solved.mesh;
    const int front = mesh.stack_begin[mesh.face_triangle[face] + 1] - 1;
    double depth = 0;
    for (int k = 0; k < 3 && front != face; ++k) depth = std::max(depth, z(front, k) - z(face, k));
    return depth > hidden_depth_;
  }

  double z(int face, int corner) const {
    return builder_.position(surface_.sheets.vertex[corner_of(face, corner)]).z;
  }

  bool is_whole(int face) const {
    const std::vector<int>& begin = surface_.cuts.begin;
    const int* edge = &surface_.sheets.edge[corner_of(face, 0)];
    return std::all_of(edge, edge + 3, [&begin](int e) { return begin[e] == begin[e + 1]; });
  }

  void append(int face, int from, int to, std::vector<EdgePoint>& chain) const {
    append_edge_points(surface_, {face, 3 - from - to}, (from + 1) % 3 != to, chain);
  }

  /// Joins both chains by triangles (left, right, next) from the lowest corner to the highest,
  /// always advancing to the lower of the two next points, so that every cross edge lies within the
  /// range of an edge piece.
  template <class AddTriangle>
  void zip(AddTriangle add_triangle) const {
    size_t i = 0;
    size_t j = 0;
    while (i + 1 < left_.size() || j + 1 < right_.size()) {
      const bool advance_left = j + 1 == right_.size() ||
                                (i + 1 < left_.size() && left_[i + 1].level <= right_[j + 1].level);
      const int next = advance_left ? left_[i + 1].vertex : right_[j + 1].vertex;
      add_triangle(left_[i].vertex, right_[j].vertex, next);
      ++(advance_left ? i : j);
    }
  }

  const CutSurface& surface_;
  ModelBuilder& builder_;
  double hidden_depth_;
  std::vector<EdgePoint> left_;   ///< from the lowest corner straight to the highest
  std::vector<EdgePoint> right_;  ///< by way of the middle one
};

constexpr int64_t max_triangles = int64_t{1} << 24;
/// tau / tolerance; the rest of the tolerance is for heights so small that they count as 0.
constexpr double chord_share = 15.0 / 16;

/// Returns the vertices at both ends of an edge, in its direction.
std::array<int, 2> edge_ends(const SheetSurface& surface, int edge) {
  const FaceEdge owner = surface.edge_owner[edge];
  return {surface.vertex[corner_of(owner.face, next_place(owner.corner))],
          surface.vertex[corner_of(owner.face, last_place(owner.corner))]};
}

std::vector<double> vertex_levels(const SheetSurface& surface, const Inflation& inflation,
                                  double tolerance) {
  std::vector<double> level(surface.vertex_node.size());
  for (size_t v = 0; v < level.size(); ++v)
    level[v] = rim_level(inflation.u[surface.vertex_node[v]], tolerance);
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

/// Returns the number of triangles of every kept face: one more than there are cuts on its edges.
std::vector<int64_t> count_pieces(const SheetSurface& surface, const std::vector<int>& cuts) {
  std::vector<int64_t> pieces;
  for (size_t f = 0; f < surface.edge.size(); f += 3) {
    if (surface.edge[f] < 0) continue;
    int64_t count = 1;
    for (size_t k = 0; k < 3; ++k) count += cuts[surface.edge[f + k]];
    pieces.push_back(count);
  }
  return pieces;
}

double position_of_height(double f, double u_first, double u_last) {
  return std::clamp((f * std::abs(f) - u_first) / (u_last - u_first), 0.0, 1.0);
}

void place_cuts(const SheetSurface& surface, const Inflation& inflation, double tolerance,
                EdgeCuts& cuts) {
  for (size_t e = 0; e < surface.edge_owner.size(); ++e) {
    const auto [a, b] = edge_ends(surface, static_cast<int>(e));
    const double u_first = inflation.u[surface.vertex_node[a]];
    const double u_last = inflation.u[surface.vertex_node[b]];
    for (int i = cuts.begin[e]; i < cuts.begin[e + 1]; ++i) {
      cuts.level[i] = cut_level(cuts.vertex_level[a], cuts.vertex_level[b], i - cuts.begin[e]);
      cuts.t[i] = position_of_height(rim_height(cuts.level[i], tolerance), u_first, u_last);
    }
  }
}

/// Returns the number of pieces of a span. Rounding must not turn a span of one level into two
/// pieces of half a level: neighbouring chains of cuts advance in step only because pieces of a cut
/// edge are longer than half a level.
int piece_count(double span) {
  const double slack = 1e-9;
  return static_cast<int>(std::clamp(std::ceil(span - slack), 1.0, 1e6));
}

bool changes_sign(double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

}  // namespace

void append_edge_points(const CutSurface& surface, FaceEdge edge, bool backwards,
                        std::vector<EdgePoint>& points) {
  const auto& [solved, sheets, cuts] = surface;
  const int e = sheets.edge[3 * edge.face + edge.corner];
  const auto end_point = [&surface, edge](int side, double t) {
    const int vertex = surface.sheets.vertex[corner_of(edge.face, (edge.corner + side) % 3)];
    return EdgePoint{vertex, surface.cuts.vertex_level[vertex], t};
  };
  const int first_cut = static_cast<int>(sheets.vertex_node.size());
  const bool owner = sheets.edge_owner[e].face == edge.face;
  const bool reversed = backwards == owner;
  const int copied = owner || cuts.twin[e] < 0 ? 0 : cuts.twin[e] - cuts.begin[e];
  const int count = cuts.begin[e + 1] - cuts.begin[e];
  points.push_back(end_point(backwards ? 2 : 1, 0));
  for (int n = 0; n < count; ++n) {
    const int i = reversed ? cuts.begin[e + 1] - 1 - n : cuts.begin[e] + n;
    points.push_back({first_cut + copied + i, cuts.level[i], reversed ? 1 - cuts.t[i] : cuts.t[i]});
  }
  points.push_back(end_point(backwards ? 1 : 2, 1));
}

Status cut_faces(const CutSurface& surface, double hidden_depth, const RunContext& context,
                 ModelBuilder& builder) {
  FaceCutter cutter(surface, hidden_depth, builder);
  const int faces = static_cast<int>(surface.solved.mesh.faces.size());
  for (int f = 0; f < faces; ++f) {
    if (f % 4096 == 0 && context.cancelled()) return interrupted_error();
    if (surface.sheets.edge[corner_of(f, 0)] >= 0) cutter.cut(f);
  }
  return Done{};
}

Result<EdgeCuts> cut_edges(const SheetSurface& surface, const Inflation& inflation,
                           const ModelOptions& options) {
  const int64_t max_pieces = int64_t{1} << (2 * options.max_rim_levels);
  double tolerance = options.rim_tolerance;
  EdgeCuts cuts;
  std::vector<int> count;
  std::vector<int64_t> pieces;
  for (;; tolerance *= 2) {
    cuts.vertex_level = vertex_levels(surface, inflation, tolerance);
    count = cut_counts(surface, cuts.vertex_level);
    pieces = count_pieces(surface, count);
    if (std::all_of(pieces.begin(), pieces.end(), [&](int64_t n) { return n <= max_pieces; }))
      break;
  }
  const int64_t total = std::accumulate(pieces.begin(), pieces.end(), int64_t{0});
  if (total > max_triangles)
    return Error{ErrorCode::limit,
                 "the surface would have " + std::to_string(total) + " triangles, more than " +
                     std::to_string(max_triangles),
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
  place_cuts(surface, inflation, tolerance, cuts);
  return cuts;
}

double rim_level(double u, double tolerance) {
  const double f = std::sqrt(std::abs(u));
  if (f <= tolerance / 32) return 0;
  return std::copysign(0.5 * (std::sqrt(1 + 2 * f / (chord_share * tolerance)) - 1), u);
}

double rim_height(double level, double tolerance) {
  return 2 * (chord_share * tolerance) * level * (std::abs(level) + 1);
}

int cut_count(double first, double last) {
  if (changes_sign(first, last))
    return piece_count(std::abs(first)) + piece_count(std::abs(last)) - 1;
  return piece_count(std::abs(last - first)) - 1;
}

double cut_level(double first, double last, int i) {
  if (!changes_sign(first, last)) {
    const int pieces = piece_count(std::abs(last - first));
    return first + (last - first) * (i + 1) / pieces;
  }
  const int before = piece_count(std::abs(first));
  if (i < before) return first * (before - 1 - i) / before;
  return last * (i + 1 - before) / piece_count(std::abs(last));
}

}  // namespace relievo::relief
