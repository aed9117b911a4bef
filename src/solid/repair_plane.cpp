#include "solid/repair_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace relievo {
namespace {

constexpr int most_repairs = 4000;

double length(GridPoint a, GridPoint b) {
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

class PlaneRepair {
 public:
  explicit PlaneRepair(HeightField& field) : field_(field) {}

  Status run() {
    for (int repairs = 0; repairs < most_repairs; ++repairs) {
      bad_ = first_bad();
      if (bad_ < 0) return Done{};
      if (!drop_between() && !collapse() && !move_corner()) break;
    }
    return Error{ErrorCode::internal, "the surface folds over at this size", ""};
  }

 private:
  using Triangle = std::array<int, 3>;

  int point(int vertex) const { return field_.vertex_point[vertex]; }

  int64_t area(const Triangle& t) const {
    return turn(field_.place(t[0]), field_.place(t[1]), field_.place(t[2]));
  }

  int first_bad() const {
    for (int t = 0; t < static_cast<int>(field_.triangles.size()); ++t)
      if (area(field_.triangles[t]) <= 0) return t;
    return -1;
  }

  /// Finds the triangle with the edge between two points in this direction, or -1 at the rim;
  /// `corners` begins with the edge.
  int triangle_at(int from, int to, Triangle& corners) const {
    for (int t = 0; t < static_cast<int>(field_.triangles.size()); ++t) {
      const Triangle& triangle = field_.triangles[t];
      for (int k = 0; k < 3; ++k) {
        if (point(triangle[k]) != from || point(triangle[(k + 1) % 3]) != to) continue;
        corners = {triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
        return t;
      }
    }
    return -1;
  }

  void remove(int t) {
    field_.triangles.erase(field_.triangles.begin() + t);
    field_.triangle_part.erase(field_.triangle_part.begin() + t);
  }

  /// Removes the bad triangle between its neighbours: the corner opposite to its longest edge lies
  /// on or beyond that edge and becomes a point of it for the triangle across.
  bool drop_between() {
    Triangle own = field_.triangles[bad_];
    const auto longer = [&](int i, int j) {
      return length(field_.place(own[i]), field_.place(own[(i + 1) % 3])) >
             length(field_.place(own[j]), field_.place(own[(j + 1) % 3]));
    };
    int k = longer(1, 0) ? 1 : 0;
    if (longer(2, k)) k = 2;
    std::rotate(own.begin(), own.begin() + k, own.end());
    Triangle other{};
    const int across = triangle_at(point(own[1]), point(own[0]), other);
    if (across < 0) {
      remove(bad_);
      return true;
    }
    const auto [b, a, apex] = other;
    if (point(apex) == point(own[2])) return false;
    const int middle = b == own[1] && a == own[0] ? own[2] : add_on_edge(own[2], a, b);
    const Triangle first{b, middle, apex};
    const Triangle second{middle, a, apex};
    if (area(first) <= 0 || area(second) <= 0) return false;
    field_.triangles[across] = first;
    field_.triangles[bad_] = second;
    field_.triangle_part[bad_] = field_.triangle_part[across];
    return true;
  }

  /// Adds a vertex over the point of `at` that is interpolated between a and b.
  int add_on_edge(int at, int a, int b) {
    const double from = length(field_.place(a), field_.place(at));
    const double to = length(field_.place(at), field_.place(b));
    const double s = from / (from + to);
    return field_.add_vertex_between(a, b, s, point(at), field_.height_between(a, b, s));
  }

  /// Moves one end of an edge to the other, the shortest edge first.
  bool collapse() {
    const Triangle own = field_.triangles[bad_];
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
      return length(field_.place(own[i]), field_.place(own[(i + 1) % 3])) <
             length(field_.place(own[j]), field_.place(own[(j + 1) % 3]));
    });
    for (const int k : order) {
      const int p = point(own[k]);
      const int q = point(own[(k + 1) % 3]);
      if (merge(p, q) || merge(q, p)) return true;
    }
    return false;
  }

  /// Moves a corner to one of its neighbours, the nearest first, so that nothing is turned over.
  bool move_corner() {
    for (const int v : Triangle(field_.triangles[bad_])) {
      const int p = point(v);
      std::vector<std::pair<double, int>> beside;
      for (const Triangle& t : field_.triangles)
        if (point(t[0]) == p || point(t[1]) == p || point(t[2]) == p)
          for (const int w : t)
            if (point(w) != p)
              beside.emplace_back(length(field_.place(w), field_.place(v)), point(w));
      std::sort(beside.begin(), beside.end());
      for (const auto& [far, q] : beside)
        if (merge(p, q)) return true;
    }
    return false;
  }

  /// Moves point p to q if that turns no other triangle over and no two triangles come to share one
  /// side of an edge.
  bool merge(int p, int q) {
    std::vector<int> gone;
    std::vector<std::array<int, 2>> edges;
    for (int t = 0; t < static_cast<int>(field_.triangles.size()); ++t) {
      const Triangle& triangle = field_.triangles[t];
      const auto uses = [&](int wanted) {
        return std::any_of(triangle.begin(), triangle.end(),
                           [&](int v) { return point(v) == wanted; });
      };
      const bool has_p = uses(p);
      const bool has_q = uses(q);
      if (!has_p && !has_q) continue;
      if (has_p && has_q) {
        gone.push_back(t);
        continue;
      }
      std::array<GridPoint, 3> places{};
      std::array<int, 3> points{};
      for (int k = 0; k < 3; ++k) {
        points[k] = point(triangle[k]) == p ? q : point(triangle[k]);
        places[k] = field_.points[points[k]];
      }
      if (has_p && turn(places[0], places[1], places[2]) <= 0) return false;
      for (int k = 0; k < 3; ++k) edges.push_back({points[k], points[(k + 1) % 3]});
    }
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    carry_out(p, q, gone);
    return true;
  }

  void carry_out(int p, int q, const std::vector<int>& gone) {
    // Within a smooth surface the vertex that moves becomes the other one.
    std::vector<std::pair<int, int>> replaced;
    for (const int t : gone) {
      int from = -1;
      int to = -1;
      for (const int v : field_.triangles[t]) {
        if (point(v) == p) from = v;
        if (point(v) == q) to = v;
      }
      replaced.emplace_back(from, to);
    }
    for (auto t = gone.rbegin(); t != gone.rend(); ++t) remove(*t);
    for (Triangle& triangle : field_.triangles)
      for (int& v : triangle)
        for (const auto& [from, to] : replaced)
          if (v == from) v = to;
    for (int& at : field_.vertex_point)
      if (at == p) at = q;
  }

  HeightField& field_;
  int bad_ = -1;
};

/// Moves a fan's point into the fan, as far as `gap` where its triangles allow that.
void pull_in(const CornerFans& fans, size_t f, double gap, HeightField& field) {
  const int first = fans.begin[f];
  const int end = fans.begin[f + 1];
  const int at = field.vertex_point[field.corner_vertex(fans.corners[first])];
  const GridPoint from = field.points[at];
  Point2 inwards;
  for (int i = first; i < end; ++i)
    for (const int side : {1, 2}) {
      const int corner = fans.corners[i];
      const GridPoint to = field.place(field.triangles[corner / 3][(corner % 3 + side) % 3]);
      inwards = inwards + 1 / length(from, to) * (as_point(to) - as_point(from));
    }
  if (norm(inwards) == 0) return;
  for (double step = gap; step >= 2; step /= 2) {
    const Point2 move = step / norm(inwards) * inwards;
    const GridPoint place{from.x + std::llround(move.x), from.y + std::llround(move.y)};
    bool fits = true;
    for (int i = first; i < end && fits; ++i) {
      const std::array<int, 3>& t = field.triangles[fans.corners[i] / 3];
      const int k = fans.corners[i] % 3;
      fits = turn(place, field.place(t[(k + 1) % 3]), field.place(t[(k + 2) % 3])) > 0;
    }
    if (!fits) continue;
    std::vector<std::pair<int, int>> copies;
    field.points.push_back(place);
    if (!field.floor.empty()) field.floor.push_back(field.floor[at]);
    for (int i = first; i < end; ++i) {
      int& v = field.triangles[fans.corners[i] / 3][fans.corners[i] % 3];
      auto copy = std::find_if(copies.begin(), copies.end(),
                               [v](const auto& pair) { return pair.first == v; });
      if (copy == copies.end()) {
        const int point = static_cast<int>(field.points.size()) - 1;
        copy = copies.insert(copies.end(), {v, field.add_vertex(point, field.vertex_height[v],
                                                                field.normals[v], field.uvs[v])});
      }
      v = copy->second;
    }
    return;
  }
}

void separate_fans(double gap, HeightField& field) {
  const CornerFans fans = collect_fans(field, connect_field(field));
  std::vector<char> taken(field.points.size());
  for (size_t f = 0; f < fans.size(); ++f) {
    const int point = field.vertex_point[field.corner_vertex(fans.corners[fans.begin[f]])];
    if (taken[point] != 0)
      pull_in(fans, f, gap, field);
    else
      taken[point] = 1;
  }
}

}  // namespace

Status repair_plane(double gap, HeightField& field) {
  if (Status status = PlaneRepair(field).run(); !status) return status;
  separate_fans(gap, field);
  return Done{};
}

}  // namespace relievo
