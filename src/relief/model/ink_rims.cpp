#include "relief/model/ink_rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/compose.h"
#include "kernel/image/filters.h"
#include "kernel/meshing/segment_grid.h"
#include "relief/model/fill_triangle.h"

namespace relievo {
namespace {

constexpr double upright = 1e-6;       ///< z of normals at outlines, at most
constexpr double widest_ink = 0.03;    ///< of the drawing's diagonal
constexpr double least_contrast = 40;  ///< between ink and the paint beside it, of 255
constexpr double inked_share = 0.5;    ///< of a part's silhouette
constexpr double reach_of_ink = 2;     ///< in widths of ink, how far a rim comes forward
constexpr double probe = 2;            ///< px, where to look on both sides of an outline
constexpr int longest_view = 512;  ///< px, of the view in which distances between parts are taken
/// Canvas px; less is none, so that no file rounds a wall away.
constexpr double least_rise = 0.01;
constexpr double leaning = 0.1;  ///< z of normals that tell how round a rim is, at least

/// An edge of a part beside which there is only paper, as its triangle runs along it.
struct RimEdge {
  std::array<int, 2> vertices{};
  int part = 0;

  std::pair<int, int> ends() const { return std::minmax(vertices[0], vertices[1]); }
};

/// A drawing's pixels with what the model shows on each.
class RimView {
 public:
  RimView(const Model& model, const Image8& rgba)
      : model_(model),
        rgba_(rgba),
        scale_(rgba.width / model.width),
        front_(front_parts(model, {rgba.width, rgba.height})),
        shrunk_front_(front_parts(
            model, fitted_size(rgba.width, rgba.height,
                               std::min(longest_view, std::max(rgba.width, rgba.height))))) {}

  double scale() const { return scale_; }
  const Image16& shrunk_front() const { return shrunk_front_; }

  /// A vertex's place moved towards the inside of its outline, in pixels.
  Point2 inwards(int vertex, double by) const {
    const Point2 uv = model_.uvs[vertex];
    const Point3 n = model_.normals[vertex];
    const double length = std::max(1e-12, norm(Point2{n.x, n.y}));
    return {uv.x * rgba_.width - by * n.x / length, uv.y * rgba_.height + by * n.y / length};
  }

  /// The part seen there, from 1; 0 where there is paper.
  int part_at(Point2 p) const {
    const int x = static_cast<int>(std::floor(p.x));
    const int y = static_cast<int>(std::floor(p.y));
    const bool on = x >= 0 && y >= 0 && x < front_.width && y < front_.height;
    return on ? front_.at(x, y) : 0;
  }

  /// Of a place on the drawing, 0 to 255.
  double brightness(Point2 p) const {
    const int x = std::clamp(static_cast<int>(p.x), 0, rgba_.width - 1);
    const int y = std::clamp(static_cast<int>(p.y), 0, rgba_.height - 1);
    const uint8_t* c = &rgba_.at(x, y);
    return (on_paper(c[0], c[3]) + on_paper(c[1], c[3]) + on_paper(c[2], c[3])) / 3.0;
  }

 private:
  const Model& model_;
  const Image8& rgba_;
  double scale_;
  Image16 front_;
  Image16 shrunk_front_;
};

/// The edges of all triangles along outlines, those with the same ends beside each other.
std::vector<RimEdge> upright_edges(const Model& model) {
  std::vector<RimEdge> edges;
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const ModelPart& part = model.parts[p];
    for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
      for (size_t k = 0; k < 3; ++k) {
        const int a = model.triangles[t][k];
        const int b = model.triangles[t][(k + 1) % 3];
        if (std::abs(model.normals[a].z) <= upright && std::abs(model.normals[b].z) <= upright)
          edges.push_back({{a, b}, static_cast<int>(p)});
      }
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const RimEdge& a, const RimEdge& b) { return a.ends() < b.ends(); });
  return edges;
}

std::vector<RimEdge> find_rims(const Model& model, const RimView& view) {
  const std::vector<RimEdge> edges = upright_edges(model);
  std::vector<RimEdge> rims;
  for (size_t i = 0; i < edges.size(); ++i) {
    const RimEdge& edge = edges[i];
    if (i + 1 < edges.size() && edges[i + 1].ends() == edge.ends()) continue;
    if (i > 0 && edges[i - 1].ends() == edge.ends()) continue;
    const auto [a, b] = edge.vertices;
    if (view.part_at(0.5 * (view.inwards(a, -probe) + view.inwards(b, -probe))) == 0 &&
        view.part_at(0.5 * (view.inwards(a, probe) + view.inwards(b, probe))) == edge.part + 1)
      rims.push_back(edge);
  }
  return rims;
}

/// The width of the ink from a vertex inwards, px of the drawing, where there is ink with paint
/// beside it.
std::optional<double> ink_width(const RimView& view, int vertex, double widest) {
  std::vector<double> values;
  for (double t = 0.5; t < 2 * widest; t += 1)
    values.push_back(view.brightness(view.inwards(vertex, t)));
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  const auto darkest = std::min_element(values.begin(), half);
  const double paint = *std::max_element(darkest, values.end());
  if (paint - *darkest < least_contrast) return std::nullopt;
  const double between = 0.5 * (paint + *darkest);
  const auto end = std::find_if(darkest, values.end(), [between](double v) { return v > between; });
  return static_cast<double>(end - values.begin());
}

/// Which parts are inked along most of their silhouettes, and how broadly in the median, px of the
/// drawing; 0 where none is.
std::vector<double> inked_parts(const Model& model, const RimView& view,
                                const std::vector<RimEdge>& rims, double widest) {
  std::vector<std::vector<double>> widths(model.parts.size());
  std::vector<size_t> all(model.parts.size(), 0);
  for (const RimEdge& rim : rims) {
    ++all[rim.part];
    const auto width = ink_width(view, rim.vertices[0], widest);
    if (width && *width <= widest) widths[rim.part].push_back(*width);
  }
  std::vector<double> median(model.parts.size(), 0);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    std::vector<double>& found = widths[p];
    if (found.empty() ||
        static_cast<double>(found.size()) < inked_share * static_cast<double>(all[p]))
      continue;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    median[p] = *middle;
  }
  return median;
}

/// A vertex of what is seen of a part, near its silhouette.
struct BandVertex {
  int vertex = 0;
  Point2 place;         ///< canvas px
  double distance = 0;  ///< canvas px to the silhouette
  double freedom = 0;   ///< 0 beside other parts, 1 away from them
};

/// Precondition: there are points.
SegmentGrid point_grid(const std::vector<Point2>& points) {
  Box2 box;
  for (const Point2 p : points) box.add(p);
  SegmentGrid grid(box, points.size());
  grid.build(points.size(), [&](size_t i) { return std::pair(points[i], points[i]); });
  return grid;
}

/// Brings the rims of one part forward.
class RimRaiser {
 public:
  /// `reach`: canvas px from the silhouette.
  RimRaiser(Model& model, const RimView& view, int part, double reach)
      : model_(model), view_(view), part_(part), reach_(reach) {}

  /// How far each vertex near the part's silhouette comes forward.
  std::vector<std::pair<int, double>> rises(const std::vector<RimEdge>& rims) {
    find_band(rims);
    std::vector<Point2> steep;
    std::vector<double> roots;
    for (const BandVertex& near : band_) {
      const Point3 n = model_.normals[near.vertex];
      if (near.distance < 0.4 * reach_ || n.z < leaning) continue;
      roots.push_back(2 * std::sqrt(near.distance) * norm(Point2{n.x, n.y}) / n.z);
      steep.push_back(near.place);
    }
    if (steep.empty()) return {};
    const SegmentGrid grid = point_grid(steep);
    std::vector<std::pair<int, double>> found;
    for (const BandVertex& near : band_) {
      const double root = mean_around(near.place, grid, steep, roots);
      const double rest = 1 - std::sqrt(near.distance / reach_);
      const double rise = near.freedom * 0.5 * std::sqrt(reach_) * root * rest * rest;
      if (rise > 0) found.emplace_back(near.vertex, rise);
    }
    return found;
  }

 private:
  Point2 place(int v) const { return {model_.positions[v].x, model_.positions[v].y}; }

  /// The vertices of what is seen of the part within reach of its silhouette, away from others.
  void find_band(const std::vector<RimEdge>& rims) {
    const ModelPart& part = model_.parts[part_];
    std::vector<int> seen;
    for (int t = part.first_triangle;
         t < part.first_triangle + part.triangle_count - part.hidden_count; ++t)
      seen.insert(seen.end(), model_.triangles[t].begin(), model_.triangles[t].end());
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    if (seen.empty()) return;
    std::vector<Point2> places;
    for (const int v : seen) places.push_back(place(v));
    const SegmentGrid grid = point_grid(places);
    std::vector<double> nearest(seen.size(), std::numeric_limits<double>::infinity());
    for (const RimEdge& rim : rims) {
      if (rim.part != part_) continue;
      const Point2 a = place(rim.vertices[0]);
      const Point2 b = place(rim.vertices[1]);
      grid.for_cells(a, b, reach_, [&](size_t cell) {
        for (const int* i = grid.begin(cell); i != grid.end(cell); ++i)
          nearest[*i] = std::min(nearest[*i], distance_to_segment(places[*i], a, b));
      });
    }
    const Image<int32_t> away = distance_to_others();
    for (size_t i = 0; i < seen.size(); ++i) {
      const double free = nearest[i] < reach_ ? freedom(seen[i], away) : 0;
      if (free > 0) band_.push_back({seen[i], places[i], nearest[i], free});
    }
  }

  /// From every pixel of the shrunk view to the next that shows another part.
  Image<int32_t> distance_to_others() const {
    const Image16& front = view_.shrunk_front();
    Image8 others(front.width, front.height, 1);
    for (size_t i = 0; i < front.pixels.size(); ++i)
      others.pixels[i] = front.pixels[i] != 0 && front.pixels[i] != part_ + 1 ? 1 : 0;
    return squared_distance_to(others);
  }

  /// 0 beside other parts, 1 away from them.
  double freedom(int v, const Image<int32_t>& away) const {
    if (away.at(0, 0) == no_distance) return 1;
    const double pixel = model_.width / away.width;
    const double x = std::clamp(model_.uvs[v].x * away.width - 0.5, 0.0, away.width - 1.0);
    const double y = std::clamp(model_.uvs[v].y * away.height - 0.5, 0.0, away.height - 1.0);
    double far = 0;
    for (const int u : {0, 1})
      for (const int w : {0, 1}) {
        const int column = std::min(static_cast<int>(x) + u, away.width - 1);
        const int row = std::min(static_cast<int>(y) + w, away.height - 1);
        const double share =
            std::max(0.0, 1 - std::abs(x - column)) * std::max(0.0, 1 - std::abs(y - row));
        far += share * std::sqrt(static_cast<double>(away.at(column, row)));
      }
    const double t = std::clamp((far - 1.5) * pixel / reach_, 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }

  double mean_around(Point2 p, const SegmentGrid& grid, const std::vector<Point2>& places,
                     const std::vector<double>& values) const {
    const double radius = 2 * reach_;
    double sum = 0;
    double weight = 0;
    grid.for_cells(p, p, radius, [&](size_t cell) {
      for (const int* i = grid.begin(cell); i != grid.end(cell); ++i) {
        const Point2 off = places[*i] - p;
        const double w = std::max(0.0, 1 - dot(off, off) / (radius * radius));
        sum += w * w * values[*i];
        weight += w * w;
      }
    });
    return weight > 0 ? sum / weight : 0;
  }

  Model& model_;
  const RimView& view_;
  int part_;
  double reach_;
  std::vector<BandVertex> band_;
};

/// Walls below raised edges, in the paint beside the ink.
class RimWalls {
 public:
  /// `rise`: of every vertex, already in the model.
  RimWalls(Model& model, const RimView& view, const std::vector<double>& rise)
      : model_(model), view_(view), rise_(rise), top_(rise.size(), -1), foot_(rise.size(), -1) {}

  /// `inside`: px of the drawing from the outline to where there is paint.
  void add(const RimEdge& rim, double inside, std::vector<std::array<int, 3>>& walls) {
    const auto [a, b] = rim.vertices;
    if (rise_[a] + rise_[b] <= 0) return;
    stand(a, rim.part, inside);
    stand(b, rim.part, inside);
    if (rise_[a] > 0) walls.push_back({top_[b], top_[a], foot_[a]});
    if (rise_[b] > 0) walls.push_back({top_[b], foot_[a], foot_[b]});
  }

 private:
  void stand(int v, int part, double inside) {
    if (top_[v] >= 0) return;
    const double most = inside + std::min(inside, rise_[v] * view_.scale());
    top_[v] = copy(v, 0, part, inside);
    foot_[v] = rise_[v] > 0 ? copy(v, rise_[v], part, most) : top_[v];
  }

  int copy(int v, double lower, int part, double inside) {
    const Point3 position = model_.positions[v];
    const Point3 normal = model_.normals[v];
    Point2 uv = model_.uvs[v];
    const Point2 paint = view_.inwards(v, inside);
    if (view_.part_at(paint) == part + 1) {
      const Point2 edge = view_.inwards(v, 0);
      uv = {uv.x * (edge.x != 0 ? paint.x / edge.x : 1),
            uv.y * (edge.y != 0 ? paint.y / edge.y : 1)};
    }
    model_.positions.push_back({position.x, position.y, position.z - lower});
    model_.normals.push_back(normal);
    model_.uvs.push_back(uv);
    return static_cast<int>(model_.positions.size()) - 1;
  }

  Model& model_;
  const RimView& view_;
  const std::vector<double>& rise_;
  std::vector<int> top_;
  std::vector<int> foot_;
};

void insert_walls(const std::vector<std::vector<std::array<int, 3>>>& walls, Model& model) {
  std::vector<std::array<int, 3>> triangles;
  for (size_t p = 0; p < walls.size(); ++p) {
    ModelPart& part = model.parts[p];
    const auto begin = model.triangles.begin() + part.first_triangle;
    part.first_triangle = static_cast<int>(triangles.size());
    triangles.insert(triangles.end(), walls[p].begin(), walls[p].end());
    triangles.insert(triangles.end(), begin, begin + part.triangle_count);
    part.triangle_count += static_cast<int>(walls[p].size());
  }
  model.triangles = std::move(triangles);
}

}  // namespace

void narrow_inked_rims(Model& model, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  if (rgba.empty()) return;
  const RimView view(model, rgba);
  const std::vector<RimEdge> rims = find_rims(model, view);
  const double widest = widest_ink * norm(Point2{1.0 * rgba.width, 1.0 * rgba.height});
  const std::vector<double> widths = inked_parts(model, view, rims, widest);
  std::vector<double> rise(model.positions.size(), 0);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    if (widths[p] == 0) continue;
    const double reach = reach_of_ink * (widths[p] + 1) / view.scale();
    for (const auto& [v, by] : RimRaiser(model, view, static_cast<int>(p), reach).rises(rims))
      if (by >= least_rise) rise[v] = std::max(rise[v], by);
  }
  for (size_t v = 0; v < rise.size(); ++v) model.positions[v].z += rise[v];
  RimWalls builder(model, view, rise);
  std::vector<std::vector<std::array<int, 3>>> walls(model.parts.size());
  for (const RimEdge& rim : rims) builder.add(rim, 1.25 * widths[rim.part] + 2, walls[rim.part]);
  insert_walls(walls, model);
}

}  // namespace relievo
