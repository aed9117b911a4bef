#include "relief/model/cut_faces.h"

#include <algorithm>
#include <utility>

namespace relievo {
namespace {

/// The corners of a face by rising level.
struct RisingCorners {
  std::array<int, 3> corner{0, 1, 2};
  bool even = true;  ///< whether they run as the face does
};

RisingCorners rising_corners(const CutSurface& surface, int face) {
  RisingCorners rising;
  const auto lower = [&surface, face](int a, int b) {
    const std::vector<double>& level = surface.cuts.vertex_level;
    const std::vector<int>& vertex = surface.sheets.vertex;
    return level[vertex[corner_of(face, a)]] < level[vertex[corner_of(face, b)]];
  };
  for (const int i : {0, 1, 0}) {
    if (!lower(rising.corner[i + 1], rising.corner[i])) continue;
    std::swap(rising.corner[i], rising.corner[i + 1]);
    rising.even = !rising.even;
  }
  return rising;
}

class FaceCutter {
 public:
  FaceCutter(const CutSurface& surface, double hidden_depth, ModelBuilder& builder)
      : surface_(surface), builder_(builder), hidden_depth_(hidden_depth) {}

  void cut(int face) {
    if (whole(face)) {
      const int* v = &surface_.sheets.vertex[corner_of(face, 0)];
      builder_.add_triangle(run_of(face), v[0], v[2], v[1]);
      return;
    }
    const RisingCorners rising = rising_corners(surface_, face);
    const auto [low, middle, high] = rising.corner;
    left_.clear();
    right_.clear();
    append(face, low, high, left_);
    append(face, low, middle, right_);
    right_.pop_back();
    append(face, middle, high, right_);
    zip(run_of(face), rising.even);
  }

 private:
  /// Where two surfaces all but touch, the lower one goes on looking like the drawing, so that it
  /// makes no difference which of them a viewer shows.
  TriangleRun run_of(int face) const {
    const LayeredMesh& mesh = surface_.mesh;
    const int front = mesh.stack_begin[mesh.face_triangle[face] + 1] - 1;
    double depth = 0;
    for (int k = 0; k < 3 && front != face; ++k) depth = std::max(depth, z(front, k) - z(face, k));
    return {mesh.face_part[face], depth > hidden_depth_};
  }

  double z(int face, int corner) const {
    return builder_.position(surface_.sheets.vertex[corner_of(face, corner)]).z;
  }

  bool whole(int face) const {
    const std::vector<int>& begin = surface_.cuts.begin;
    const int* edge = &surface_.sheets.edge[corner_of(face, 0)];
    return std::all_of(edge, edge + 3, [&begin](int e) { return begin[e] == begin[e + 1]; });
  }

  void append(int face, int from, int to, std::vector<EdgePoint>& chain) const {
    append_edge_points(surface_, {face, 3 - from - to}, (from + 1) % 3 != to, chain);
  }

  /// Joins both chains from the lowest corner to the highest, always advancing to the lower of
  /// the two next points, so that every cross edge lies within the range of an edge piece.
  void zip(TriangleRun run, bool even) {
    size_t i = 0;
    size_t j = 0;
    while (i + 1 < left_.size() || j + 1 < right_.size()) {
      const bool advance_left = j + 1 == right_.size() ||
                                (i + 1 < left_.size() && left_[i + 1].level <= right_[j + 1].level);
      const int next = advance_left ? left_[i + 1].vertex : right_[j + 1].vertex;
      add_triangle(run, even, left_[i].vertex, right_[j].vertex, next);
      ++(advance_left ? i : j);
    }
  }

  void add_triangle(TriangleRun run, bool even, int left, int right, int next) {
    if (left == right || next == left || next == right) return;
    if (even)
      builder_.add_triangle(run, left, next, right);
    else
      builder_.add_triangle(run, left, right, next);
  }

  const CutSurface& surface_;
  ModelBuilder& builder_;
  double hidden_depth_;
  std::vector<EdgePoint> left_;   ///< from the lowest corner straight to the highest
  std::vector<EdgePoint> right_;  ///< the same by way of the middle one
};

}  // namespace

void append_edge_points(const CutSurface& surface, FaceEdge edge, bool backwards,
                        std::vector<EdgePoint>& points) {
  const auto& [mesh, sheets, cuts] = surface;
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
  const int faces = static_cast<int>(surface.mesh.faces.size());
  for (int f = 0; f < faces; ++f) {
    if (f % 4096 == 0 && context.cancelled()) return interrupted_error();
    if (surface.sheets.edge[corner_of(f, 0)] >= 0) cutter.cut(f);
  }
  return Done{};
}

}  // namespace relievo
