#include "relief/finish/ink_rims.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/finish/floor.h"
#include "relief/finish/rim_surroundings.h"

namespace relievo::relief {
namespace {

// Tuned on the samples, the lengths by turning them to a side view.
constexpr double upright = 1e-6;         ///< greatest |z| of unit normals at outlines: round-off
constexpr double widest_ink = 0.03;      ///< of the drawing's diagonal
constexpr double blurred = 1.5;          ///< px of the drawing beside ink that hold some of it
constexpr double broad_share = 0.8;      ///< quantile of the widths of ink nearby that counts
constexpr double broadest_line = 3;      ///< usual widths; broader darkness is paint, as on hooves
constexpr double nearby = 4;             ///< widths of ink over which measurements are averaged
constexpr double reach_of_ink = 6;       ///< widths of ink up to which surfaces are lowered
constexpr double deepest_ink = 0.5;      ///< of the squared height in the middle of a limb, at most
constexpr double begin_of_paint = 0.85;  ///< k: the surface begins at k F, F the ink end's height
constexpr double above_others = 0.002;   ///< of the canvas: least height of ink above parts below

/// A vertex on a part's seen outline, with nothing nearer beyond it.
struct RimVertex {
  Point2 place;      ///< canvas px, y up
  double z = 0;      ///< px
  double width = 0;  ///< of the ink inwards, canvas px; 0 if there is none
  double u = 0;      ///< px^2, the squared height over the rim at the end of the ink
  double most = 0;   ///< px^2, the greatest squared height nearby
  double fade = 0;   ///< smoothed share of inked outline nearby, in [0, 1]
};

/// Returns the vertices of a part, ascending.
std::vector<int> vertices_of(const Model& model, const ModelPart& part) {
  std::vector<int> vertices;
  for (int t = part.first_triangle; t < part.end(); ++t)
    vertices.insert(vertices.end(), model.triangles[t].begin(), model.triangles[t].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Returns the vertices on a part's seen outline, ascending. `given`: positions before any
/// lowering.
std::vector<RimVertex> find_rim(const Model& model, const std::vector<Point3>& given,
                                const RimView& view, int part, const std::vector<int>& vertices) {
  std::vector<RimVertex> rim;
  const double widest = widest_ink * view.scale() * norm(Point2{model.width, model.height});
  for (const int v : vertices) {
    if (std::abs(model.normals[v].z) > upright || !view.ends_here(v, part)) continue;
    const Point3 p = given[v];
    const double width = view.ink_width(v, widest).value_or(0);
    rim.push_back({{p.x, p.y}, p.z, width > 0 ? (width + blurred) / view.scale() : 0});
  }
  return rim;
}

/// Returns a quantile of values, which it reorders. Precondition: there is a value.
double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Returns the width of ink along a part's outline, canvas px, or 0 unless at least half of the
/// outline is inked. Where dark paint reaches the outline, the ink gets the median width.
double settle_widths(std::vector<RimVertex>& rim) {
  std::vector<double> widths;
  for (const RimVertex& v : rim)
    if (v.width > 0) widths.push_back(v.width);
  if (widths.empty() || 2 * widths.size() < rim.size()) return 0;
  const double usual = quantile(widths, 0.5);
  const auto is_paint = [usual](double width) { return width > broadest_line * usual; };
  std::replace_if(widths.begin(), widths.end(), is_paint, usual);
  for (RimVertex& v : rim)
    if (is_paint(v.width)) v.width = usual;
  return quantile(widths, broad_share);
}

template <class Item>
std::vector<Point2> places_of(const std::vector<Item>& items) {
  std::vector<Point2> places;
  for (const Item& item : items) places.push_back(item.place);
  return places;
}

/// A vertex of a part near its rim.
struct BandVertex {
  int vertex = 0;
  Point2 place;         ///< canvas px
  double distance = 0;  ///< canvas px to the rim
  double f = 0;         ///< px, height over the rim beside it
};

/// Lowers the rim of one part so that its surface begins where its ink ends.
class RimFlattener {
 public:
  RimFlattener(const std::vector<Point3>& given, const std::vector<int>& vertices,
               std::vector<RimVertex> rim, double width)
      : width_(width), rim_(std::move(rim)), beside_(places_of(rim_), reach_of_ink * width) {
    find_band(given, vertices);
    const BesideRim band(places_of(band_), reach_of_ink * width);
    smooth_widths();
    for (RimVertex& v : rim_)
      if (v.width > 0) find_heights(band, v);
    smooth_ends();
  }

  /// Returns vertices near the rim and the distances by which they are lowered, px.
  std::vector<std::pair<int, double>> drops() const {
    std::vector<std::pair<int, double>> found;
    for (const BandVertex& near : band_) {
      RimVertex rim;
      beside_.for_each(near.place, near.distance, [&](size_t i, double weight) {
        rim.u += weight * rim_[i].u;
        rim.most += weight * rim_[i].most;
        rim.fade += weight * rim_[i].fade;
        rim.width += weight * rim_[i].width;
      });
      const double drop =
          rim.fade * beside_.share_at(near.distance) * (near.f - lowered(near.f, rim));
      if (drop > 0) found.emplace_back(near.vertex, drop);
    }
    return found;
  }

 private:
  /// Computes the height that a height f over the rim is lowered to, at least half a line's width:
  ///   0 if s < 0,   F s^2 (T (3 - 2 s) - (T - k) (1 - s)) if s < 1,   f otherwise,
  /// a cubic from 0 with slope 0 to T F with slope 1. F = sqrt(u) is the height at the end of the
  /// ink, M = sqrt(most) the greatest nearby, T = min(2, M / F) and s = (f / F - k) / (T - k).
  static double lowered(double f, const RimVertex& rim) {
    const double end = std::sqrt(rim.u);
    if (end <= 0) return f;
    const double again = std::min(2.0, std::sqrt(rim.most) / end);
    if (f >= again * end) return f;
    const double span = again - begin_of_paint;
    const double s = std::max(0.0, (f / end - begin_of_paint) / span);
    const double rise = s * s * (again * (3 - 2 * s) - span * (1 - s));
    return std::max(end * rise, std::min(f, 0.5 * rim.width));
  }

  void find_band(const std::vector<Point3>& given, const std::vector<int>& vertices) {
    for (const int v : vertices) {
      const Point3 p = given[v];
      BandVertex near{v, {p.x, p.y}};
      near.distance = beside_.distance_to(near.place);
      if (near.distance >= reach_of_ink * width_) continue;
      double rim = 0;
      beside_.for_each(near.place, near.distance,
                       [&](size_t i, double weight) { rim += weight * rim_[i].z; });
      near.f = std::max(0.0, p.z - rim);
      band_.push_back(near);
    }
  }

  void smooth_widths() {
    std::vector<double> smooth;
    for (RimVertex& v : rim_) {
      std::vector<double> widths;
      double all = 0;
      beside_.for_each_within(v.place, nearby * width_, [&](size_t i, double) {
        ++all;
        if (rim_[i].width > 0) widths.push_back(rim_[i].width);
      });
      const double share = std::clamp(2 * static_cast<double>(widths.size()) / all - 0.5, 0.0, 1.0);
      v.fade = share * share * (3 - 2 * share);
      smooth.push_back(widths.empty() ? 0 : quantile(widths, broad_share));
    }
    for (size_t i = 0; i < rim_.size(); ++i) rim_[i].width = smooth[i];
  }

  /// Averages the measured heights over the rim nearby: their noise would fold the surface.
  void smooth_ends() {
    std::vector<Point2> smooth;
    for (const RimVertex& v : rim_) {
      Point2 sum;
      double all = 0;
      beside_.for_each_within(v.place, nearby * width_, [&](size_t i, double distance) {
        if (rim_[i].width <= 0) return;
        const double weight = 1 - distance / (nearby * width_);
        sum = sum + weight * Point2{rim_[i].u, rim_[i].most};
        all += weight;
      });
      smooth.push_back(all > 0 ? (1 / all) * sum : Point2{});
    }
    for (size_t i = 0; i < rim_.size(); ++i) {
      rim_[i].u = smooth[i].x;
      rim_[i].most = smooth[i].y;
    }
  }

  /// Measures the greatest squared height nearby and the one at the end of the ink, rather too
  /// large than too small: a rest of ink would be a streak down the wall. At distance t from the
  /// rim f^2 is about proportional to t, and f^2 / t larger near the rim.
  void find_heights(const BesideRim& band, RimVertex& v) const {
    std::vector<double> at_end;
    double farther = 0;
    double distances = 0;
    band.for_each_within(v.place, nearby * v.width, [&](size_t i, double) {
      const BandVertex& near = band_[i];
      const double u = near.f * near.f;
      v.most = std::max(v.most, u);
      if (near.distance < 0.5 * v.width || near.distance > 3 * v.width) return;
      farther += u;
      distances += near.distance;
      if (near.distance < 1.2 * v.width) at_end.push_back(u * v.width / near.distance);
    });
    if (distances == 0) return;
    const double u = at_end.empty() ? v.width * farther / distances : quantile(at_end, broad_share);
    v.u = std::min(u, deepest_ink * v.most);
  }

  double width_;
  std::vector<RimVertex> rim_;
  BesideRim beside_;
  std::vector<BandVertex> band_;
};

/// Returns the vertices near the outline of a part that ends on others that were lowered, and the
/// distances by which they follow those, px. `before`, `after`: the others before and after that.
/// `touching`: px, greatest gap between heights that touch. `reach`: canvas px over which the part
/// follows.
std::vector<std::pair<int, double>> following_drops(const Floor& before, const Floor& after,
                                                    const Model& model,
                                                    const std::vector<Point3>& given,
                                                    const std::vector<int>& vertices,
                                                    double touching, double reach) {
  std::vector<Point2> rim;
  std::vector<double> gaps;
  for (const int v : vertices) {
    if (std::abs(model.normals[v].z) > upright) continue;
    rim.push_back({given[v].x, given[v].y});
    const auto [least, most] = before.range_at(model.uvs[v]);
    const bool touches = given[v].z >= least - touching && given[v].z <= most + touching;
    const auto now = after.range_at(model.uvs[v]);
    gaps.push_back(touches ? std::max(0.0, 0.5 * (least + most - now[0] - now[1])) : 0);
  }
  std::vector<std::pair<int, double>> found;
  if (std::none_of(gaps.begin(), gaps.end(), [](double gap) { return gap > 0; })) return found;
  const BesideRim beside(std::move(rim), reach);
  for (const int v : vertices) {
    const Point2 place{given[v].x, given[v].y};
    const double distance = beside.distance_to(place);
    if (distance >= reach) continue;
    double drop = 0;
    beside.for_each(place, distance, [&](size_t i, double weight) { drop += weight * gaps[i]; });
    if (drop > 0) found.emplace_back(v, drop * beside.share_at(distance));
  }
  return found;
}

/// Returns 1 for those of `count` vertices that several parts share, which lie at joins, else 0.
std::vector<uint8_t> sewn_vertices(const std::vector<std::vector<int>>& parts, size_t count) {
  std::vector<uint8_t> taken(count, 0);
  std::vector<uint8_t> sewn(count, 0);
  for (const std::vector<int>& part : parts)
    for (const int v : part) {
      sewn[v] = taken[v];
      taken[v] = 1;
    }
  return sewn;
}

/// Reduces the lowering of a part's vertices towards its joins, to 0 there, within `reach` (canvas
/// px).
void keep_joins(const std::vector<Point3>& given, const std::vector<int>& part,
                const std::vector<uint8_t>& sewn, double reach, std::vector<double>& back) {
  std::vector<Point2> join;
  for (const int v : part)
    if (sewn[v] != 0) join.push_back({given[v].x, given[v].y});
  if (join.empty() || reach <= 0) return;
  const BesideRim beside(std::move(join), reach);
  for (const int v : part)
    if (back[v] > 0) back[v] *= 1 - beside.share_at(beside.distance_to({given[v].x, given[v].y}));
}

}  // namespace

void narrow_inked_rims(Model& model, const Drawing& drawing) {
  if (drawing.rgba.empty()) return;
  const RimView view(model, drawing.rgba);
  const double lift = above_others * std::max(model.width, model.height);
  const std::vector<Point3> given = model.positions;
  std::vector<std::vector<int>> parts;
  for (const ModelPart& part : model.parts) parts.push_back(vertices_of(model, part));
  const std::vector<uint8_t> sewn = sewn_vertices(parts, given.size());
  Floor before(model);
  Floor after(model);
  double broadest = 0;
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const std::vector<int>& vertices = parts[p];
    std::vector<double> back(given.size(), 0);
    const auto lower = [&](int v, double by) {
      const double z = given[v].z - back[v];
      const double least = std::min(z, after.range_at(model.uvs[v])[1] + lift);
      back[v] = given[v].z - std::max(z - by, least);
    };
    std::vector<RimVertex> rim = find_rim(model, given, view, static_cast<int>(p), vertices);
    const double width = settle_widths(rim);
    if (width > 0)
      for (const auto& [v, by] : RimFlattener(given, vertices, std::move(rim), width).drops())
        lower(v, by);
    if (broadest > 0)
      for (const auto& [v, by] : following_drops(before, after, model, given, vertices, lift,
                                                 reach_of_ink / 3 * broadest))
        lower(v, by);
    broadest = std::max(broadest, width);
    keep_joins(given, vertices, sewn, reach_of_ink / 2 * (width > 0 ? width : broadest), back);
    for (const int v : vertices) model.positions[v].z = given[v].z - back[v];
    before.add(model, model.parts[p], given);
    after.add(model, model.parts[p], model.positions);
  }
}

}  // namespace relievo::relief
