#include "solid/stand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "kernel/meshing/triangulate.h"

namespace relievo {
namespace {

constexpr int most_levels = 64;  ///< tried for a clean cut
constexpr int disc_sides = 48;   ///< of a round plate
constexpr double blunt = 0.1;    ///< radians that the blunt left and right ends of a disc leave out

/// Cuts off the part of a field that lies below a level.
class FeetCutter {
 public:
  FeetCutter(const HeightField& field, int64_t level) : field_(field), level_(level) {}

  /// Returns false if two edges meet the level in one point; then the field is of no use.
  bool cut() {
    const std::vector<std::array<int, 3>> triangles = std::exchange(field_.triangles, {});
    const std::vector<int> parts = std::exchange(field_.triangle_part, {});
    for (const std::array<int, 3>& t : triangles)
      for (const int v : t)
        if (field_.place(v).y == level_) return false;
    for (size_t t = 0; t < triangles.size() && clean_; ++t) keep(triangles[t], parts[t]);
    return clean_;
  }

  HeightField take() && { return std::move(field_); }

 private:
  bool above(int vertex) const { return field_.place(vertex).y > level_; }

  void keep(const std::array<int, 3>& triangle, int part) {
    std::vector<int> ring;
    for (int k = 0; k < 3; ++k) {
      const int a = triangle[k];
      const int b = triangle[(k + 1) % 3];
      if (above(a)) ring.push_back(a);
      if (above(a) != above(b)) ring.push_back(above(a) ? crossing(a, b) : crossing(b, a));
    }
    for (size_t i = 2; i < ring.size(); ++i) {
      field_.triangles.push_back({ring[0], ring[i - 1], ring[i]});
      field_.triangle_part.push_back(part);
    }
  }

  /// Returns the vertex at which the edge from a, above, to b meets the level.
  int crossing(int a, int b) {
    const auto [known, fresh] = vertices_.try_emplace({a, b}, 0);
    if (!fresh) return known->second;
    const GridPoint p = field_.place(a);
    const GridPoint q = field_.place(b);
    const double s = static_cast<double>(p.y - level_) / static_cast<double>(p.y - q.y);
    const int at = point(field_.vertex_point[a], field_.vertex_point[b], s);
    const int64_t height = between(field_.vertex_height[a], field_.vertex_height[b], s);
    return known->second = field_.add_vertex_between(a, b, s, at, height);
  }

  static int64_t between(int64_t from, int64_t to, double s) {
    return from + std::llround(s * static_cast<double>(to - from));
  }

  int point(int a, int b, double s) {
    const auto [known, fresh] = points_.try_emplace({a, b}, static_cast<int>(field_.points.size()));
    if (!fresh) return known->second;
    const int64_t x = between(field_.points[a].x, field_.points[b].x, s);
    clean_ = taken_.insert(x).second && clean_;
    field_.points.push_back({x, level_});
    if (!field_.floor.empty())
      field_.floor.push_back(
          {between(field_.floor[a].height, field_.floor[b].height, s), field_.floor[a].part});
    return known->second;
  }

  HeightField field_;
  int64_t level_;
  bool clean_ = true;
  std::map<std::pair<int, int>, int> vertices_;
  std::map<std::pair<int, int>, int> points_;
  std::set<int64_t> taken_;
};

/// Builds the plate below the feet of a figure.
class StandBuilder {
 public:
  StandBuilder(const Stand& stand, HeightField& field)
      : stand_(stand), field_(field), top_(lowest(field)) {}

  Status add() {
    if (Status status = find_feet(); !status) return status;
    for (const GridPoint p : stand_.others) add_to_feet(p.x, p.y);
    add_mass();
    shape();
    lay_points();
    return triangulate_plate();
  }

 private:
  int64_t above_plate(int vertex) const {
    return field_.floor_height(field_.vertex_point[vertex]) + field_.vertex_height[vertex];
  }

  void add_to_feet(int64_t x, int64_t z) {
    left_ = std::min(left_, x);
    right_ = std::max(right_, x);
    back_ = std::min(back_, z);
    front_ = std::max(front_, z);
  }

  Status find_feet() {
    for (const std::array<int, 3>& t : field_.triangles)
      for (int k = 0; k < 3; ++k) {
        const int a = t[k];
        const int b = t[(k + 1) % 3];
        if (field_.place(a).y == top_) touching_.insert(field_.vertex_point[a]);
        if (field_.place(a).y != top_ || field_.place(b).y != top_) continue;
        soles_.insert({field_.place(a).x, field_.vertex_point[a]});
        soles_.insert({field_.place(b).x, field_.vertex_point[b]});
        joined_to_right_.insert(field_.place(a).x);
        for (const int v : {a, b}) {
          add_to_feet(field_.place(v).x, above_plate(v));
          add_to_feet(field_.place(v).x, field_.floor_height(field_.vertex_point[v]));
        }
      }
    if (soles_.empty() || touching_.size() != soles_.size())
      return Error{ErrorCode::internal, "the feet do not lie on one level", ""};
    return Done{};
  }

  /// Widens the footprint so that the centre of mass lies over the plate.
  void add_mass() {
    double mass = 0;
    double x = 0;
    double z = 0;
    for (const std::array<int, 3>& t : field_.triangles) {
      const auto area =
          static_cast<double>(turn(field_.place(t[0]), field_.place(t[1]), field_.place(t[2])));
      for (const int v : t) {
        const auto high = static_cast<double>(field_.vertex_height[v]);
        const auto floor = static_cast<double>(field_.floor_height(field_.vertex_point[v]));
        mass += area * high;
        x += area * high * static_cast<double>(field_.place(v).x);
        z += area * high * (floor + 0.5 * high);
      }
    }
    if (mass > 0) add_to_feet(std::llround(x / mass), std::llround(z / mass));
  }

  /// Computes the corners of the plate as seen from above.
  void shape() {
    const int64_t x = (left_ + right_) / 2;
    middle_ = (back_ + front_) / 2;
    if (!stand_.round) {
      const int64_t wide = std::min((right_ - left_) / 2 + stand_.margin, stand_.widest / 2);
      half_depth_ = std::min((front_ - back_) / 2 + stand_.margin, stand_.widest / 2);
      bends_ = {{x - wide, half_depth_}, {x + wide, half_depth_}};
      return;
    }
    const double radius = std::min(
        0.5 * std::hypot(static_cast<double>(right_ - left_), static_cast<double>(front_ - back_)) +
            static_cast<double>(stand_.margin),
        0.5 * static_cast<double>(stand_.widest));
    for (int i = 0; i <= disc_sides / 2; ++i) {
      const double angle =
          blunt + (std::numbers::pi - 2 * blunt) * static_cast<double>(i) / (disc_sides / 2.0);
      bends_[x - std::llround(radius * std::cos(angle))] = std::llround(radius * std::sin(angle));
    }
  }

  int64_t depth_at(int64_t x) const {
    auto right = bends_.upper_bound(x);
    if (right == bends_.end()) return bends_.rbegin()->second;
    if (right == bends_.begin()) return right->second;
    const auto left = std::prev(right);
    const double s =
        static_cast<double>(x - left->first) / static_cast<double>(right->first - left->first);
    return left->second + std::llround(s * static_cast<double>(right->second - left->second));
  }

  int lay_point(int64_t x, int64_t y) {
    plate_.push_back(static_cast<int>(field_.points.size()));
    field_.points.push_back({x, y});
    field_.floor.push_back({middle_ - depth_at(x), stand_.part});
    return static_cast<int>(plate_.size()) - 1;
  }

  /// Adds the points of the plate. The back of a foot and that of the plate are one surface, which
  /// falls between them within `slope`, so little that it counts as level.
  void lay_points() {
    const int64_t slope = std::max<int64_t>(stand_.thickness / 10, 2);
    for (const auto& [x, point] : soles_) plate_.push_back(point);
    std::set<int64_t> ends;
    for (auto at = soles_.begin(); at != soles_.end(); ++at) {
      const auto next = std::next(at);
      if (next == soles_.end() || joined_to_right_.count(at->first) == 0)
        if (next == soles_.end() || next->first - at->first > 3 * slope)
          ends.insert(at->first + slope);
      const bool first = at == soles_.begin();
      if (first || (joined_to_right_.count(std::prev(at)->first) == 0 &&
                    at->first - std::prev(at)->first > 3 * slope))
        ends.insert(at->first - slope);
    }
    for (const auto& [x, depth] : bends_)
      if (is_free(x, slope)) ends.insert(x);
    for (const int64_t x : ends) lay_point(x, top_);
    // Below that, every line of the plate's outline is straight.
    for (const auto& [x, point] : soles_) ends.insert(x);
    for (const auto& [x, depth] : bends_) ends.insert(x);
    int last = -1;
    for (const int64_t x : ends) {
      const int at = lay_point(x, top_ - slope);
      if (last >= 0) lines_.push_back({last, at});
      last = at;
      if (bends_.count(x) > 0) lines_.push_back({at, lay_point(x, top_ - stand_.thickness)});
    }
  }

  /// Returns whether a point of the upper edge is off all feet.
  bool is_free(int64_t x, int64_t slope) const {
    const auto right = soles_.lower_bound({x, -1});
    if (right != soles_.end() && right->first - x <= 2 * slope) return false;
    if (right == soles_.begin()) return true;
    const auto left = std::prev(right);
    return x - left->first > 2 * slope && joined_to_right_.count(left->first) == 0;
  }

  Status triangulate_plate() {
    std::vector<Point2> places;
    for (const int p : plate_) places.push_back(as_point(field_.points[p]));
    const auto mesh = triangulate(places, lines_);
    if (!mesh) return mesh.error();
    const auto first = static_cast<int>(field_.vertex_point.size());
    for (const int p : plate_) {
      const int64_t front = middle_ + depth_at(field_.points[p].x);
      field_.add_vertex(p, std::max<int64_t>(front - field_.floor[p].height, 1), {0, 0, 1},
                        stand_.uv);
    }
    for (std::array<int, 3> t : mesh->triangles) {
      // The part behind a triangle is that of its first corner.
      while (t[0] < static_cast<int>(soles_.size())) std::rotate(t.begin(), t.begin() + 1, t.end());
      field_.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      field_.triangle_part.push_back(stand_.part);
    }
    return Done{};
  }

  const Stand& stand_;
  HeightField& field_;
  int64_t top_;
  std::set<int> touching_;                   ///< points on the level of the plate's top
  std::set<std::pair<int64_t, int>> soles_;  ///< x and index of points along feet
  std::set<int64_t> joined_to_right_;        ///< x of those at which a foot continues to the right
  // The box of the feet seen from above: x along the drawing, z towards the viewer.
  int64_t left_ = std::numeric_limits<int64_t>::max();
  int64_t right_ = std::numeric_limits<int64_t>::min();
  int64_t back_ = std::numeric_limits<int64_t>::max();
  int64_t front_ = std::numeric_limits<int64_t>::min();
  int64_t middle_ = 0;  ///< of the plate, towards the viewer
  int64_t half_depth_ = 0;
  std::map<int64_t, int64_t> bends_;       ///< half the plate's depth at its corners, by x
  std::vector<int> plate_;                 ///< points, those of feet first
  std::vector<std::array<int, 2>> lines_;  ///< between them, by their index there
};

}  // namespace

int64_t lowest(const HeightField& field) {
  int64_t low = std::numeric_limits<int64_t>::max();
  for (const std::array<int, 3>& t : field.triangles)
    for (const int v : t) low = std::min(low, field.place(v).y);
  return low;
}

Status cut_feet(int64_t sunk, HeightField& field) {
  const int64_t level = lowest(field) + sunk;
  for (int above = 0; above < most_levels; ++above) {
    FeetCutter cut(field, level + above);
    if (!cut.cut()) continue;
    field = std::move(cut).take();
    return Done{};
  }
  return Error{ErrorCode::internal, "the feet cannot be cut level", ""};
}

Status add_stand(const Stand& stand, HeightField& field) {
  return StandBuilder(stand, field).add();
}

}  // namespace relievo
