#include "relief/surface/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace relievo::relief {
namespace {

/// A surface's copy of the base vertex at an end of an open edge.
struct EdgeEnd {
  int base = -1;
  double z = 0;
  int vertex = -1;
};

bool operator<(const EdgeEnd& a, const EdgeEnd& b) {
  return std::tie(a.base, a.z, a.vertex) < std::tie(b.base, b.z, b.vertex);
}

class WallBuilder {
 public:
  WallBuilder(const CutSurface& surface, double weld_tolerance, ModelBuilder& builder)
      : surface_(surface), weld_tolerance_(weld_tolerance), builder_(builder) {
    collect_ends();
    weld_ends();
  }

  void close(const OpenEdge& open) {
    first_.clear();
    second_.clear();
    append_edge_points(surface_, open[0], false, first_);
    append_edge_points(surface_, open[1], true, second_);
    weld_cuts();
    if (coincide()) return;
    first_higher_ = first_is_higher(open);
    part_ = surface_.solved.mesh.face_part[open[first_higher_ ? 0 : 1].face];
    find_normals();
    for (EdgePoint& p : first_) p.vertex = builder_.copy_vertex(p.vertex, normal_at(p.t));
    for (EdgePoint& p : second_) p.vertex = builder_.copy_vertex(p.vertex, normal_at(p.t));
    const int triangle = surface_.solved.mesh.face_triangle[open[0].face];
    const std::array<int, 3>& base = surface_.solved.mesh.triangles[triangle];
    zip(base[next_place(open[0].corner)], base[last_place(open[0].corner)]);
  }

 private:
  void collect_ends() {
    for (const OpenEdge& open : surface_.sheets.open_edges)
      for (const FaceEdge edge : open)
        for (const int side : {1, 2}) {
          const int v = surface_.sheets.vertex[corner_of(edge.face, (edge.corner + side) % 3)];
          const int node = surface_.sheets.vertex_node[v];
          ends_.push_back({surface_.solved.mesh.node_vertex[node], z(v), v});
        }
    std::sort(ends_.begin(), ends_.end());
  }

  void weld_ends() {
    for (size_t i = 1; i < ends_.size(); ++i) {
      EdgeEnd& end = ends_[i];
      const EdgeEnd& below = ends_[i - 1];
      if (end.base != below.base || z(end.vertex) - z(below.vertex) > weld_tolerance_) continue;
      end.z = below.z;
      builder_.set_height(end.vertex, end.z);
    }
  }

  double z(int vertex) const { return builder_.position(vertex).z; }

  /// Moves the inner points of the second copy to those of the first if all nearly coincide.
  void weld_cuts() {
    if (first_.size() != second_.size()) return;
    const auto near = [this](const EdgePoint& a, const EdgePoint& b) {
      return norm(builder_.position(a.vertex) - builder_.position(b.vertex)) <= weld_tolerance_;
    };
    if (!std::equal(first_.begin(), first_.end(), second_.begin(), near)) return;
    for (size_t i = 1; i + 1 < first_.size(); ++i)
      builder_.set_position(second_[i].vertex, builder_.position(first_[i].vertex));
  }

  bool coincide(int a, int b) const { return builder_.position(a) == builder_.position(b); }

  bool coincide() const {
    const auto same = [this](const EdgePoint& a, const EdgePoint& b) {
      return coincide(a.vertex, b.vertex);
    };
    return std::equal(first_.begin(), first_.end(), second_.begin(), second_.end(), same);
  }

  /// Returns the area below one copy of the edge, whose length counts as 1.
  double area_below(const std::vector<EdgePoint>& points) const {
    double area = 0;
    for (size_t i = 1; i < points.size(); ++i)
      area +=
          0.5 * (points[i].t - points[i - 1].t) * (z(points[i].vertex) + z(points[i - 1].vertex));
    return area;
  }

  bool first_is_higher(const OpenEdge& open) const {
    const double difference = area_below(first_) - area_below(second_);
    if (difference != 0) return difference > 0;
    return surface_.solved.mesh.face_part[open[0].face] >=
           surface_.solved.mesh.face_part[open[1].face];
  }

  /// Computes the wall's normals at both ends. The wall continues a rim: the normal is the
  /// horizontal part of the steeper of both normals there, turned to the lower side, unless that
  /// does not face across the edge.
  void find_normals() {
    const Point3 along =
        builder_.position(first_.back().vertex) - builder_.position(first_.front().vertex);
    const double sign = first_higher_ ? 1 : -1;
    const Point3 across = normalized({-sign * along.y, sign * along.x, 0});
    normal_front_ = rim_normal(first_.front().vertex, second_.front().vertex, across);
    normal_back_ = rim_normal(first_.back().vertex, second_.back().vertex, across);
  }

  Point3 rim_normal(int a, int b, Point3 across) const {
    const Point3 steeper = builder_.normal(builder_.normal(a).z <= builder_.normal(b).z ? a : b);
    const Point3 rim = normalized({steeper.x, steeper.y, 0});
    const double facing = dot(rim, across);
    if (std::abs(facing) <= 0.5) return across;
    return facing > 0 ? rim : -1 * rim;
  }

  Point3 normal_at(double t) const {
    return normalized((1 - t) * normal_front_ + t * normal_back_);
  }

  /// Fills the polygon between both copies of the edge over base vertices `front` and `back`.
  void zip(int front, int back) {
    size_t i = 0;
    size_t j = 0;
    const size_t last_i = first_.size() - 1;
    const size_t last_j = second_.size() - 1;
    while (i < last_i || j < last_j) {
      const bool forward = j == last_j || (i < last_i && advance_first(i, j));
      const int a = first_[i].vertex;
      const int b = second_[j].vertex;
      const int next = forward ? first_[i + 1].vertex : second_[j + 1].vertex;
      const bool starts = i == 0 && j == 0;
      ++(forward ? i : j);
      if (starts)
        fan(next, b, a, front);
      else if (i == last_i && j == last_j)
        fan(forward ? a : b, first_[i].vertex, second_[j].vertex, back);
      else
        add_triangle(a, next, b);
    }
  }

  /// Returns whether to advance on the first copy: to the next point along the edge, unless only
  /// the other triangle faces outwards.
  bool advance_first(size_t i, size_t j) const {
    const bool preferred = prefer_first(i, j);
    return faces_inwards(i, j, preferred) && !faces_inwards(i, j, !preferred) ? !preferred
                                                                              : preferred;
  }

  /// Returns whether the next point along the edge is on the first copy. Of points side by side the
  /// lower cross edge is preferred, so that nothing sticks out where both copies cross.
  bool prefer_first(size_t i, size_t j) const {
    if (first_[i + 1].t != second_[j + 1].t) return first_[i + 1].t < second_[j + 1].t;
    return z(first_[i + 1].vertex) + z(second_[j].vertex) <=
           z(first_[i].vertex) + z(second_[j + 1].vertex);
  }

  bool faces_inwards(size_t i, size_t j, bool first) const {
    const Point2 a = in_wall(first_[i]);
    const double turn =
        cross(in_wall(first ? first_[i + 1] : second_[j + 1]) - a, in_wall(second_[j]) - a);
    return first_higher_ ? turn > 0 : turn < 0;
  }

  Point2 in_wall(const EdgePoint& p) const { return {p.t, z(p.vertex)}; }

  /// Adds a triangle whose vertical edge from -> to over a base vertex is cut at the heights of all
  /// surfaces that end there.
  void fan(int apex, int from, int to, int base) {
    const double z_from = z(from);
    const double z_to = z(to);
    const auto at_height = [&](double z) {
      return std::lower_bound(ends_.begin(), ends_.end(), EdgeEnd{base, z, -1});
    };
    auto begin = at_height(std::min(z_from, z_to));
    const auto end = at_height(std::max(z_from, z_to));
    heights_.clear();
    for (; begin != end; ++begin)
      if (begin->z != std::min(z_from, z_to) && (heights_.empty() || heights_.back() != begin->z))
        heights_.push_back(begin->z);
    if (z_to < z_from) std::reverse(heights_.begin(), heights_.end());
    for (const double height : heights_) {
      const int between = builder_.copy_vertex(from, builder_.normal(from));
      builder_.set_height(between, height);
      add_triangle(apex, from, between);
      from = between;
    }
    add_triangle(apex, from, to);
  }

  void add_triangle(int a, int b, int c) {
    if (coincide(a, b) || coincide(b, c) || coincide(c, a)) return;
    builder_.add_triangle(part_, false, a, b, c);
  }

  const CutSurface& surface_;
  double weld_tolerance_;
  ModelBuilder& builder_;
  std::vector<EdgeEnd> ends_;  ///< sorted by base vertex and height
  bool first_higher_ = true;
  int part_ = -1;  ///< the higher part, which the wall belongs to
  Point3 normal_front_;
  Point3 normal_back_;
  std::vector<EdgePoint> first_;   ///< the first face's copy of the edge
  std::vector<EdgePoint> second_;  ///< the second's, in the same direction
  std::vector<double> heights_;
};

/// Returns for each part whether it reaches the silhouette. Others, such as eyes and buttons, lie
/// on the front alone.
std::vector<char> at_silhouette(const LayeredMesh& mesh) {
  std::vector<char> reaches(mesh.part_count, 0);
  const auto is_paper = [&mesh](int t) {
    return t < 0 || mesh.stack_begin[t] == mesh.stack_begin[t + 1];
  };
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& beside = mesh.neighbours[t];
    if (std::none_of(beside.begin(), beside.end(), is_paper)) continue;
    for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f)
      reaches[mesh.face_part[f]] = 1;
  }
  return reaches;
}

/// The rearmost of the sheets seen so far.
struct Rearmost {
  BackPoint point{std::numeric_limits<double>::infinity(), 0};
  bool counts = false;  ///< whether it is of a sheet with a back

  /// Adds a sheet. Those without a back, hollows and parts on the front alone, count only if
  /// nothing else does.
  void add(double u, double g, int part, bool has_back) {
    const BackPoint back{g - std::sqrt(std::abs(u)), part};
    const bool adds = has_back && u >= 0;
    const bool first = std::isinf(point.z);
    if (first || (adds && (!counts || back.z < point.z))) {
      point = back;
      counts = adds;
    }
  }
};

/// Finds the points behind a surface.
class BackFinder {
 public:
  explicit BackFinder(const SolvedSurface& solved)
      : mesh_(solved.mesh),
        u_(solved.inflation.u),
        g_(solved.ordering.g),
        has_back_(at_silhouette(mesh_)) {
    // Hidden sheets are lowered for the front alone.
    for (size_t n = 0; n < solved.ordering.lowered.size(); ++n) g_[n] += solved.ordering.lowered[n];
  }

  /// Returns the points behind the base vertices.
  std::vector<BackPoint> at_vertices() const {
    std::vector<Rearmost> below(mesh_.vertices.size());
    for (size_t f = 0; f < mesh_.faces.size(); ++f)
      for (const int n : mesh_.faces[f]) add(f, u_[n], g_[n], below[mesh_.node_vertex[n]]);
    std::vector<BackPoint> points;
    for (const Rearmost& rearmost : below) points.push_back(rearmost.point);
    return points;
  }

  /// Returns the point behind both triangles beside an edge, at position t on it.
  BackPoint at_edge(FaceEdge edge, double t) const {
    const int triangle = mesh_.face_triangle[edge.face];
    const int from = mesh_.node_vertex[mesh_.faces[edge.face][next_place(edge.corner)]];
    const int to = mesh_.node_vertex[mesh_.faces[edge.face][last_place(edge.corner)]];
    Rearmost below;
    for (const int beside : {triangle, mesh_.neighbours[triangle][edge.corner]}) {
      if (beside < 0) continue;
      for (int f = mesh_.stack_begin[beside]; f < mesh_.stack_begin[beside + 1]; ++f) {
        double u = 0;
        double g = 0;
        for (const int n : mesh_.faces[f]) {
          const int v = mesh_.node_vertex[n];
          const double weight = v == from ? 1 - t : (v == to ? t : 0);
          u += weight * u_[n];
          g += weight * g_[n];
        }
        add(f, u, g, below);
      }
    }
    return below.point;
  }

 private:
  void add(size_t face, double u, double g, Rearmost& below) const {
    const int part = mesh_.face_part[face];
    below.add(u, g, part, has_back_[part] != 0);
  }

  const LayeredMesh& mesh_;
  const std::vector<double>& u_;  ///< #N
  std::vector<double> g_;         ///< #N
  std::vector<char> has_back_;    ///< by part
};

}  // namespace

void close_open_edges(const CutSurface& surface, double weld_tolerance, ModelBuilder& builder) {
  WallBuilder walls(surface, weld_tolerance, builder);
  for (const OpenEdge& open : surface.sheets.open_edges) walls.close(open);
}

std::vector<BackPoint> back_points(const CutSurface& surface) {
  const auto& [solved, sheets, cuts] = surface;
  const BackFinder finder(solved);
  const std::vector<BackPoint> below = finder.at_vertices();
  std::vector<BackPoint> back;
  for (const int node : sheets.vertex_node) back.push_back(below[solved.mesh.node_vertex[node]]);
  const size_t edges = sheets.edge_owner.size();
  const auto append_cuts = [&, &owner = sheets.edge_owner, &cuts = cuts](size_t e) {
    for (int i = cuts.begin[e]; i < cuts.begin[e + 1]; ++i)
      back.push_back(finder.at_edge(owner[e], cuts.t[i]));
  };
  for (size_t e = 0; e < edges; ++e) append_cuts(e);
  for (size_t e = 0; e < edges; ++e)
    if (cuts.twin[e] >= 0) append_cuts(e);
  return back;
}

}  // namespace relievo::relief
