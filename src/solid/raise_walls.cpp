#include "solid/raise_walls.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "solid/field_rim.h"

namespace relievo {
namespace {

class WallRaiser {
 public:
  WallRaiser(const HeightField& field, const FieldEdges& edges, std::vector<ModelPart> parts,
             const BackPaint& paint)
      : field_(field), edges_(edges), paint_(paint) {
    model_.parts = std::move(parts);
    triangles_.resize(model_.parts.size());
    for (const GridPoint p : field.points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    collect_heights();
  }

  Status raise() {
    for (size_t v = 0; v < field_.vertex_point.size(); ++v)
      add_vertex(field_.vertex_point[v], field_.vertex_height[v], field_.normals[v], field_.uvs[v]);
    for (size_t t = 0; t < field_.triangles.size(); ++t)
      triangles_[field_.triangle_part[t]].push_back(field_.triangles[t]);
    for (int t = 0; t < static_cast<int>(field_.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k) raise_wall(t, k);
    if (field_.floor.empty()) return add_plate();
    add_floor();
    return Done{};
  }

  Model take() && {
    model_.width = field_.unit * static_cast<double>(high_.x - low_.x);
    model_.height = field_.unit * static_cast<double>(high_.y - low_.y);
    for (size_t p = 0; p < triangles_.size(); ++p) {
      model_.parts[p].first_triangle = static_cast<int>(model_.triangles.size());
      model_.parts[p].triangle_count = static_cast<int>(triangles_[p].size());
      model_.parts[p].hidden_count = 0;
      model_.triangles.insert(model_.triangles.end(), triangles_[p].begin(), triangles_[p].end());
    }
    return std::move(model_);
  }

 private:
  /// An upright line at an end of a wall, from the top downwards.
  struct Column {
    std::vector<int64_t> heights;
    std::vector<int> vertices;
  };

  void collect_heights() {
    heights_.resize(field_.points.size());
    for (size_t t = 0; t < field_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int v = field_.triangles[t][k];
        heights_[field_.vertex_point[v]].push_back(field_.vertex_height[v]);
        if (edges_.across[t][k] >= 0) continue;
        heights_[field_.vertex_point[v]].push_back(0);
        heights_[field_.vertex_point[field_.triangles[t][(k + 1) % 3]]].push_back(0);
      }
    for (std::vector<int64_t>& heights : heights_) {
      std::sort(heights.begin(), heights.end());
      heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    }
  }

  int add_vertex(int point, int64_t height, Point3 normal, Point2 uv) {
    const GridPoint p = field_.points[point];
    model_.positions.push_back(
        {field_.unit * static_cast<double>(p.x - low_.x),
         field_.unit * static_cast<double>(p.y - low_.y),
         field_.unit * static_cast<double>(field_.floor_height(point) + height)});
    model_.normals.push_back(normal);
    model_.uvs.push_back(uv);
    return static_cast<int>(model_.positions.size()) - 1;
  }

  /// Returns the heights across edge k of t, over its two ends; 0 outside the field.
  std::array<int64_t, 2> heights_across(int t, int k) const {
    const int other = edges_.across[t][k];
    if (other < 0) return {0, 0};
    std::array<int64_t, 2> heights{};
    for (const int end : {0, 1}) {
      const int point = field_.vertex_point[field_.triangles[t][(k + end) % 3]];
      for (const int v : field_.triangles[other])
        if (field_.vertex_point[v] == point) heights[end] = field_.vertex_height[v];
    }
    return heights;
  }

  /// Adds the wall along edge k of t if t is the higher side.
  void raise_wall(int t, int k) {
    const int a = field_.triangles[t][k];
    const int b = field_.triangles[t][(k + 1) % 3];
    const std::array<int64_t, 2> low = heights_across(t, k);
    if (field_.vertex_height[a] < low[0] || field_.vertex_height[b] < low[1]) return;
    if (field_.vertex_height[a] == low[0] && field_.vertex_height[b] == low[1]) return;
    const GridPoint p = field_.place(a);
    const GridPoint q = field_.place(b);
    const Point3 normal =
        normalized({static_cast<double>(q.y - p.y), static_cast<double>(p.x - q.x), 0});
    fill_column(a, low[0], normal, left_);
    fill_column(b, low[1], normal, right_);
    zip(triangles_[field_.triangle_part[t]]);
  }

  void fill_column(int top, int64_t low, Point3 normal, Column& column) {
    column.heights.clear();
    column.vertices.clear();
    const std::vector<int64_t>& all = heights_[field_.vertex_point[top]];
    auto from = std::lower_bound(all.begin(), all.end(), low);
    const auto to = std::upper_bound(from, all.end(), field_.vertex_height[top]);
    column.heights.assign(std::make_reverse_iterator(to), std::make_reverse_iterator(from));
    for (const int64_t height : column.heights)
      column.vertices.push_back(
          add_vertex(field_.vertex_point[top], height, normal, field_.uvs[top]));
  }

  void zip(std::vector<std::array<int, 3>>& triangles) const {
    size_t i = 0;
    size_t j = 0;
    while (i + 1 < left_.heights.size() || j + 1 < right_.heights.size()) {
      const bool left =
          j + 1 == right_.heights.size() ||
          (i + 1 < left_.heights.size() && left_.heights[i + 1] >= right_.heights[j + 1]);
      const int next = left ? left_.vertices[i + 1] : right_.vertices[j + 1];
      triangles.push_back({right_.vertices[j], left_.vertices[i], next});
      ++(left ? i : j);
    }
  }

  Status add_plate() {
    const auto back = triangulate_inside(field_, edges_);
    if (!back) return back.error();
    std::vector<int> vertex(field_.points.size(), -1);
    for (const std::array<int, 3>& t : *back) {
      for (const int p : t)
        if (vertex[p] < 0) vertex[p] = add_vertex(p, 0, {0, 0, -1}, paint_.plate);
      triangles_.back().push_back({vertex[t[0]], vertex[t[2]], vertex[t[1]]});
    }
    return Done{};
  }

  /// Adds the floor seen from below, with a vertex for every point and part.
  void add_floor() {
    const std::vector<Point3> normals = floor_normals();
    std::map<std::array<int, 2>, int> vertices;
    for (size_t t = 0; t < field_.triangles.size(); ++t) {
      std::array<int, 3> corners = field_.triangles[t];
      std::swap(corners[1], corners[2]);
      const int part = field_.floor[field_.vertex_point[corners[0]]].part;
      for (int& v : corners) {
        const int point = field_.vertex_point[v];
        const auto [at, fresh] = vertices.try_emplace({point, part}, 0);
        if (fresh)
          at->second = add_vertex(
              point, 0, normals[point],
              paint_.parts.empty() ? field_.uvs[v] + Point2{0, paint_.behind} : paint_.parts[part]);
        v = at->second;
      }
      triangles_[part].push_back(corners);
    }
  }

  Point3 floor_place(int point) const {
    const GridPoint p = field_.points[point];
    return {static_cast<double>(p.x), static_cast<double>(p.y),
            static_cast<double>(field_.floor[point].height)};
  }

  std::vector<Point3> floor_normals() const {
    std::vector<Point3> normals(field_.points.size());
    for (const std::array<int, 3>& t : field_.triangles) {
      std::array<int, 3> p{};
      for (int k = 0; k < 3; ++k) p[k] = field_.vertex_point[t[k]];
      const Point3 a = floor_place(p[0]);
      const Point3 down = cross(floor_place(p[2]) - a, floor_place(p[1]) - a);
      for (const int point : p) normals[point] = normals[point] + down;
    }
    for (Point3& normal : normals) normal = normalized(normal);
    return normals;
  }

  const HeightField& field_;
  const FieldEdges& edges_;
  const BackPaint& paint_;
  GridPoint low_{std::numeric_limits<int64_t>::max(), std::numeric_limits<int64_t>::max()};
  GridPoint high_{std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::min()};
  std::vector<std::vector<int64_t>>
      heights_;  ///< by point, those of all vertices over it, ascending
  Model model_;
  std::vector<std::vector<std::array<int, 3>>> triangles_;  ///< by part
  Column left_;
  Column right_;
};

}  // namespace

Result<Model> raise_walls(const HeightField& field, const FieldEdges& edges,
                          const std::vector<ModelPart>& parts, const BackPaint& paint) {
  WallRaiser raiser(field, edges, parts, paint);
  if (Status status = raiser.raise(); !status) return status.error();
  return std::move(raiser).take();
}

}  // namespace relievo
