#include "solid/snap_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "solid/lay_floor.h"

namespace relievo {
namespace {

struct PointHash {
  size_t operator()(const GridPoint& p) const {
    return static_cast<size_t>(static_cast<uint64_t>(p.x) * 0x9E3779B97F4A7C15U ^
                               (static_cast<uint64_t>(p.y) * 0xC2B2AE3D27D4EB4FU >> 7));
  }
};

int64_t on_grid(double mm, double unit) { return std::llround(mm / unit); }

/// A point of one side of a step.
struct SidePoint {
  double t = 0;
  int vertex = -1;
  bool added = false;  ///< whether only the other side had a point there
};

class Snapper {
 public:
  Snapper(const relief::VisibleSheet& sheet, const GridPlacement& placement) : sheet_(sheet) {
    const Model& model = sheet.model;
    field_.unit = placement.unit;
    const double steeper = placement.height_scale / placement.scale;
    for (const Point3 n : model.normals)
      field_.normals.push_back(normalized({steeper * n.x, steeper * n.y, n.z}));
    field_.uvs = model.uvs;
    for (const Point3 p : model.positions) {
      const Point3 q = p - placement.origin;
      field_.vertex_point.push_back(number_of({on_grid(placement.scale * q.x, field_.unit),
                                               on_grid(placement.scale * q.y, field_.unit)}));
      field_.vertex_height.push_back(on_grid(placement.height_scale * q.z, field_.unit));
    }
    if (placement.backed) lay_floor(placement);
  }

  HeightField snap() && {
    for (const relief::SheetStep& step : sheet_.steps) align(step);
    for (const ModelPart& part : sheet_.model.parts) {
      const int p = static_cast<int>(&part - sheet_.model.parts.data());
      for (int t = 0; t < part.triangle_count; ++t)
        add_triangle(sheet_.model.triangles[part.first_triangle + t], p);
    }
    return std::move(field_);
  }

 private:
  int number_of(GridPoint place) {
    const auto [at, fresh] = numbers_.try_emplace(place, static_cast<int>(field_.points.size()));
    if (fresh) field_.points.push_back(place);
    return at->second;
  }

  /// Sets the floor of every point to the deepest point behind its vertices.
  void lay_floor(const GridPlacement& placement) {
    field_.floor.assign(field_.points.size(), {std::numeric_limits<int64_t>::max(), 0});
    for (size_t v = 0; v < sheet_.back.size(); ++v) {
      const relief::BackPoint& back = sheet_.back[v];
      const double z = placement.height_scale * (back.z - placement.origin.z);
      FloorPoint& floor = field_.floor[field_.vertex_point[v]];
      if (const int64_t height = on_grid(z, field_.unit); height < floor.height)
        floor = {height, back.part};
    }
  }

  void lay_floor_between(int p, int q, double s) {
    if (field_.floor.size() == field_.points.size() || field_.floor.empty()) return;
    const FloorPoint from = field_.floor[p];
    const auto rise = static_cast<double>(field_.floor[q].height - from.height);
    field_.floor.push_back({from.height + std::llround(s * rise), from.part});
  }

  /// Returns the points of `own`, and one more wherever only the other side has one.
  std::vector<SidePoint> completed(const std::vector<relief::EdgePoint>& own,
                                   const std::vector<relief::EdgePoint>& other) {
    std::vector<SidePoint> side{{0, own.front().vertex, false}};
    size_t j = 1;
    for (size_t i = 1; i < own.size(); ++i) {
      const relief::EdgePoint& from = own[i - 1];
      const relief::EdgePoint& to = own[i];
      for (; j + 1 < other.size() && other[j].t < to.t; ++j) {
        const double s = (other[j].t - from.t) / (to.t - from.t);
        const int point = field_.vertex_point[other[j].vertex];
        const int64_t height = field_.height_between(from.vertex, to.vertex, s);
        side.push_back({other[j].t,
                        field_.add_vertex_between(from.vertex, to.vertex, s, point, height), true});
      }
      if (i + 1 < own.size() && j + 1 < other.size() && other[j].t == to.t) ++j;
      side.push_back({to.t, to.vertex, false});
    }
    return side;
  }

  /// Adds the points where the profiles of both sides cross.
  void cross_profiles(std::vector<SidePoint>& first, std::vector<SidePoint>& second) {
    std::vector<SidePoint> one{first.front()};
    std::vector<SidePoint> two{second.front()};
    for (size_t i = 1; i < first.size(); ++i) {
      const int64_t before = gap(first[i - 1], second[i - 1]);
      const int64_t after = gap(first[i], second[i]);
      if ((before < 0 && after > 0) || (before > 0 && after < 0))
        add_crossing({&first[i - 1], &first[i]}, {&second[i - 1], &second[i]},
                     static_cast<double>(before) / static_cast<double>(before - after), one, two);
      one.push_back(first[i]);
      two.push_back(second[i]);
    }
    first = std::move(one);
    second = std::move(two);
  }

  using Piece = std::array<const SidePoint*, 2>;

  void add_crossing(const Piece& a, const Piece& b, double s, std::vector<SidePoint>& one,
                    std::vector<SidePoint>& two) {
    const GridPoint p = field_.place(a[0]->vertex);
    const GridPoint q = field_.place(a[1]->vertex);
    const GridPoint place{p.x + std::llround(s * static_cast<double>(q.x - p.x)),
                          p.y + std::llround(s * static_cast<double>(q.y - p.y))};
    if (place == p || place == q) return;
    const int point = number_of(place);
    lay_floor_between(field_.vertex_point[a[0]->vertex], field_.vertex_point[a[1]->vertex], s);
    const int64_t height = field_.height_between(a[0]->vertex, a[1]->vertex, s);
    const double t = (1 - s) * a[0]->t + s * a[1]->t;
    const auto add = [&](const Piece& piece) {
      return field_.add_vertex_between(piece[0]->vertex, piece[1]->vertex, s, point, height);
    };
    one.push_back({t, add(a), true});
    two.push_back({t, add(b), true});
  }

  int64_t gap(const SidePoint& a, const SidePoint& b) const {
    return field_.vertex_height[a.vertex] - field_.vertex_height[b.vertex];
  }

  void align(const relief::SheetStep& step) {
    std::vector<SidePoint> first = completed(step.first, step.second);
    std::vector<SidePoint> second = completed(step.second, step.first);
    if (first.size() == second.size()) {
      // Points of both sides at one t lie where the first side has them.
      for (size_t i = 0; i < first.size(); ++i)
        field_.vertex_point[second[i].vertex] = field_.vertex_point[first[i].vertex];
      cross_profiles(first, second);
    }
    keep_added(first);
    keep_added(second);
  }

  static uint64_t key(int a, int b) {
    return (static_cast<uint64_t>(std::min(a, b)) << 32) | static_cast<uint32_t>(std::max(a, b));
  }

  void keep_added(const std::vector<SidePoint>& side) {
    for (size_t i = 0; i + 1 < side.size();) {
      size_t end = i + 1;
      while (side[end].added) ++end;
      if (end > i + 1) {
        std::vector<int>& inner = added_[key(side[i].vertex, side[end].vertex)];
        for (size_t k = i + 1; k < end; ++k) inner.push_back(side[k].vertex);
        if (side[i].vertex > side[end].vertex) std::reverse(inner.begin(), inner.end());
      }
      i = end;
    }
  }

  /// Adds a triangle, split over its edges with added points.
  void add_triangle(const std::array<int, 3>& triangle, int part) {
    std::vector<std::array<int, 3>> open{triangle};
    while (!open.empty()) {
      const std::array<int, 3> next = open.back();
      open.pop_back();
      if (!split(next, open)) keep(next, part);
    }
  }

  bool split(const std::array<int, 3>& triangle, std::vector<std::array<int, 3>>& open) const {
    for (int k = 0; k < 3; ++k) {
      const int a = triangle[k];
      const int b = triangle[(k + 1) % 3];
      const auto found = added_.find(key(a, b));
      if (found == added_.end()) continue;
      std::vector<int> chain = found->second;
      if (a > b) std::reverse(chain.begin(), chain.end());
      chain.insert(chain.begin(), a);
      chain.push_back(b);
      for (size_t i = 1; i < chain.size(); ++i)
        open.push_back({chain[i - 1], chain[i], triangle[(k + 2) % 3]});
      return true;
    }
    return false;
  }

  void keep(const std::array<int, 3>& t, int part) {
    const std::vector<int>& point = field_.vertex_point;
    if (point[t[0]] == point[t[1]] || point[t[1]] == point[t[2]] || point[t[2]] == point[t[0]])
      return;
    field_.triangles.push_back(t);
    field_.triangle_part.push_back(part);
  }

  const relief::VisibleSheet& sheet_;
  HeightField field_;
  std::unordered_map<GridPoint, int, PointHash> numbers_;
  std::unordered_map<uint64_t, std::vector<int>> added_;  ///< by edge, from its smaller vertex
};

}  // namespace

HeightField snap_sheet(const relief::VisibleSheet& sheet, const GridPlacement& placement) {
  return Snapper(sheet, placement).snap();
}

}  // namespace relievo
