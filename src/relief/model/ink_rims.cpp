#include "relief/model/ink_rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/compose.h"
#include "relief/model/fill_triangle.h"
#include "relief/model/rim_surroundings.h"

namespace relievo {
namespace {

constexpr double upright = 1e-6;       ///< z of normals at outlines, at most
constexpr double widest_ink = 0.03;    ///< of the drawing's diagonal
constexpr double least_contrast = 40;  ///< between ink and the paint beside it, of 255
constexpr double paint_share = 0.35;  ///< of the greatest contrast to ink, which paint has at least
constexpr double level_share = 0.1;   ///< of the contrast to ink, by which paint varies
constexpr double inked_share = 0.5;   ///< of what is seen of a part's outline
constexpr double probe = 2;           ///< px, where to look on both sides of an outline
constexpr std::ptrdiff_t antialiased = 3;  ///< px inside an outline that may hold paper
constexpr double blurred = 1.5;            ///< px beside ink that hold some of it
constexpr double broad_share = 0.8;   ///< of the widths of ink nearby lie below the one that counts
constexpr double broadest_line = 3;   ///< of the usual width, up to which darkness is ink
constexpr double nearby = 4;          ///< widths of ink
constexpr double reach_of_ink = 6;    ///< widths of ink, up to where surfaces give way
constexpr double deepest_ink = 0.7;   ///< of the squared height in the middle of a limb, at most
constexpr double round_again = 4;     ///< squared heights of the ink's end, where nothing changes
constexpr double edge_of_line = 0.5;  ///< widths of ink, how high the line's own edge is
constexpr double reach_of_others = 2;   ///< widths of ink, within which what ends on it follows
constexpr double above_others = 0.002;  ///< of the canvas, how far ink keeps above what lies below

/// A vertex of a part's outline where it is seen, with nothing nearer beyond it.
struct RimVertex {
  int vertex = 0;
  Point2 place;      ///< canvas px
  double z = 0;      ///< px
  double width = 0;  ///< of the ink inwards, canvas px; 0 where there is none
  double u = 0;      ///< px^2, the squared height over the rim where the ink ends
  double fade = 0;   ///< the share of inked outline nearby, as a weight from 0 to 1
};

/// A drawing's pixels with what the model shows on each.
class RimView {
 public:
  RimView(const Model& model, const Image8& rgba)
      : model_(model),
        rgba_(rgba),
        scale_(rgba.width / model.width),
        front_(front_parts(model, {rgba.width, rgba.height})) {}

  /// Pixels of the drawing in one of the canvas.
  double scale() const { return scale_; }

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

  /// Whether the part, from 0, is seen on one side of the vertex and none before it on the other.
  bool ends_here(int vertex, int part) const {
    return part_at(inwards(vertex, probe)) == part + 1 && part_at(inwards(vertex, -probe)) <= part;
  }

  /// The width of the ink from a vertex inwards, px of the drawing, where there is ink with paint
  /// beside it.
  std::optional<double> ink_width(int vertex, double widest) const {
    std::vector<double> values;
    for (double t = 0.5; t < 2 * widest; t += 1) values.push_back(brightness(inwards(vertex, t)));
    // An eye farther in may be darker than the ink.
    auto darkest = values.begin();
    for (auto v = values.begin(); v != values.end() && *v - *darkest < least_contrast; ++v)
      if (*v < *darkest) darkest = v;
    const double most = *std::max_element(darkest, values.end()) - *darkest;
    if (most < least_contrast) return std::nullopt;
    // Paint is the first that stays about as bright, not the brightest patch farther in.
    const auto is_paint = [&](auto v) {
      const double contrast = *v - *darkest;
      const auto ahead = v + std::min<std::ptrdiff_t>(4, values.end() - v);
      return contrast >= std::max(least_contrast, paint_share * most) &&
             *std::max_element(v, ahead) - *v <= level_share * contrast;
    };
    auto paint = darkest;
    while (!is_paint(paint)) ++paint;
    const double between = 0.5 * (*paint + *darkest);
    const auto is_light = [between](double v) { return v > between; };
    if (std::any_of(values.begin() + std::min(antialiased, darkest - values.begin()), darkest,
                    is_light))
      return std::nullopt;
    const auto end = std::find_if(darkest, values.end(), is_light);
    const auto width = static_cast<double>(end - values.begin());
    return width <= widest ? std::optional(width) : std::nullopt;
  }

 private:
  /// Of a place on the drawing, 0 to 255.
  double brightness(Point2 p) const {
    const int x = std::clamp(static_cast<int>(p.x), 0, rgba_.width - 1);
    const int y = std::clamp(static_cast<int>(p.y), 0, rgba_.height - 1);
    const uint8_t* c = &rgba_.at(x, y);
    return (on_paper(c[0], c[3]) + on_paper(c[1], c[3]) + on_paper(c[2], c[3])) / 3.0;
  }

  const Model& model_;
  const Image8& rgba_;
  double scale_;
  Image16 front_;
};

/// The vertices of a part, ascending.
std::vector<int> vertices_of(const Model& model, const ModelPart& part) {
  std::vector<int> vertices;
  for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
    vertices.insert(vertices.end(), model.triangles[t].begin(), model.triangles[t].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// The vertices along a part's outline where it is seen, ascending.
std::vector<RimVertex> find_rim(const Model& model, const std::vector<Point3>& given,
                                const RimView& view, int part, const std::vector<int>& vertices) {
  std::vector<RimVertex> rim;
  const double widest = widest_ink * view.scale() * norm(Point2{model.width, model.height});
  for (const int v : vertices) {
    if (std::abs(model.normals[v].z) > upright || !view.ends_here(v, part)) continue;
    const Point3 p = given[v];
    const double width = view.ink_width(v, widest).value_or(0);
    rim.push_back({v, {p.x, p.y}, p.z, width > 0 ? (width + blurred) / view.scale() : 0});
  }
  return rim;
}

/// A height at a quantile of values, which it reorders. Precondition: there are some.
double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The width of ink along most of a part's outline, canvas px; 0 where most has none. Where dark
/// paint reaches the outline, as on a hoof, the ink has the width that is usual elsewhere.
double settle_widths(std::vector<RimVertex>& rim) {
  std::vector<double> widths;
  for (const RimVertex& v : rim)
    if (v.width > 0) widths.push_back(v.width);
  const double least = inked_share * static_cast<double>(rim.size());
  if (widths.empty() || static_cast<double>(widths.size()) < least) return 0;
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
  double f = 0;         ///< px, the height over the rim beside it
};

/// Lets the surface of one part begin where its ink ends.
class RimFlattener {
 public:
  RimFlattener(const std::vector<Point3>& given, const std::vector<int>& vertices,
               std::vector<RimVertex> rim, double width)
      : width_(width), rim_(std::move(rim)), beside_(places_of(rim_), reach_of_ink * width) {
    find_band(given, vertices);
    const NearPoints near_band(places_of(band_));
    smooth_widths();
    for (RimVertex& v : rim_)
      if (v.width > 0) v.u = u_at_end(v, near_band);
  }

  /// How far each vertex near the rim goes back.
  std::vector<std::pair<int, double>> drops() const {
    std::vector<std::pair<int, double>> found;
    for (const BandVertex& near : band_) {
      double u = 0;
      double fade = 0;
      double width = 0;
      beside_.for_each(near.place, near.distance, [&](size_t i, double weight) {
        u += weight * rim_[i].u;
        fade += weight * rim_[i].fade;
        width += weight * rim_[i].width;
      });
      const double left = near.f - lowered(near.f, u, edge_of_line * width);
      const double drop = fade * beside_.share_at(near.distance) * left;
      if (drop > 0) found.emplace_back(near.vertex, drop);
    }
    return found;
  }

 private:
  /// The height that a height f over the rim becomes where ink ends at the squared height u: the
  /// root of a profile that begins there and is f from `round_again` times it on.
  static double lowered(double f, double u, double edge) {
    if (u <= 0 || f * f >= round_again * u) return f;
    const double past = std::max(0.0, f * f / u - 1);
    const double span = round_again - 1;
    const double b = -1 / (span * span);
    const double a = 1 - 2 * b * span;
    return std::max(std::sqrt(u * past * (a + b * past)), std::min(f, edge));
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
      beside_.rim().for_each(v.place, nearby * width_, [&](size_t i, double) {
        ++all;
        if (rim_[i].width > 0) widths.push_back(rim_[i].width);
      });
      const double share = std::clamp(2 * static_cast<double>(widths.size()) / all - 0.5, 0.0, 1.0);
      v.fade = share * share * (3 - 2 * share);
      smooth.push_back(widths.empty() ? 0 : quantile(widths, broad_share));
    }
    for (size_t i = 0; i < rim_.size(); ++i) rim_[i].width = smooth[i];
  }

  /// The squared height where ink of this width ends, rather too much than too little: what is
  /// left of the ink beyond would be a streak down the wall. Nearer to the rim f^2 / t is larger,
  /// t being the distance.
  double u_at_end(const RimVertex& v, const NearPoints& near_band) const {
    std::vector<double> at_end;
    double most = 0;
    double farther = 0;
    double distances = 0;
    near_band.for_each(v.place, nearby * v.width, [&](size_t i, double) {
      const BandVertex& near = band_[i];
      const double u = near.f * near.f;
      most = std::max(most, u);
      if (near.distance < 0.5 * v.width || near.distance > 3 * v.width) return;
      farther += u;
      distances += near.distance;
      if (near.distance < 1.2 * v.width) at_end.push_back(u * v.width / near.distance);
    });
    if (distances == 0) return 0;
    const double u = at_end.empty() ? v.width * farther / distances : quantile(at_end, broad_share);
    return std::min(u, deepest_ink * most);
  }

  double width_;
  std::vector<RimVertex> rim_;
  BesideRim beside_;
  std::vector<BandVertex> band_;
};

/// Parts that end on others that went back go with them.
class RimFollower {
 public:
  /// `touching`: px, between heights that count as one; `reach`: canvas px, of what follows.
  RimFollower(const Floor& before, const Floor& after, double touching, double reach)
      : before_(before), after_(after), touching_(touching), reach_(reach) {}

  /// How far each vertex near an outline goes back.
  std::vector<std::pair<int, double>> drops(const Model& model, const std::vector<Point3>& given,
                                            const std::vector<int>& vertices) const {
    std::vector<Point2> rim;
    std::vector<double> gaps;
    for (const int v : vertices) {
      if (std::abs(model.normals[v].z) > upright) continue;
      rim.push_back({given[v].x, given[v].y});
      gaps.push_back(gap(model.uvs[v], given[v].z));
    }
    std::vector<std::pair<int, double>> found;
    if (std::none_of(gaps.begin(), gaps.end(), [](double gap) { return gap > 0; })) return found;
    const BesideRim beside(std::move(rim), reach_);
    for (const int v : vertices) {
      const Point2 place{given[v].x, given[v].y};
      const double distance = beside.distance_to(place);
      if (distance >= reach_) continue;
      double drop = 0;
      beside.for_each(place, distance, [&](size_t i, double weight) { drop += weight * gaps[i]; });
      if (drop > 0) found.emplace_back(v, drop * beside.share_at(distance));
    }
    return found;
  }

 private:
  /// How far what touched a place at a height from below went back.
  double gap(Point2 uv, double z) const {
    const auto [least, most] = before_.range_at(uv);
    if (z < least - touching_ || z > most + touching_) return 0;
    const auto now = after_.range_at(uv);
    return std::max(0.0, 0.5 * (least + most - now[0] - now[1]));
  }

  const Floor& before_;
  const Floor& after_;
  double touching_;
  double reach_;
};

}  // namespace

void narrow_inked_rims(Model& model, const Drawing& drawing) {
  if (drawing.rgba.empty()) return;
  const RimView view(model, drawing.rgba);
  const double lift = above_others * std::max(model.width, model.height);
  const std::vector<Point3> given = model.positions;
  Floor before(model);
  Floor after(model);
  double broadest = 0;
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const std::vector<int> vertices = vertices_of(model, model.parts[p]);
    std::vector<double> back(given.size(), 0);
    const auto go_back = [&](int v, double by) {
      const double z = given[v].z - back[v];
      const double least = std::min(z, after.range_at(model.uvs[v])[1] + lift);
      back[v] = given[v].z - std::max(z - by, least);
      model.positions[v].z = std::min(model.positions[v].z, given[v].z - back[v]);
    };
    std::vector<RimVertex> rim = find_rim(model, given, view, static_cast<int>(p), vertices);
    const double width = settle_widths(rim);
    if (width > 0)
      for (const auto& [v, by] : RimFlattener(given, vertices, std::move(rim), width).drops())
        go_back(v, by);
    if (broadest > 0)
      for (const auto& [v, by] : RimFollower(before, after, lift, reach_of_others * broadest)
                                     .drops(model, given, vertices))
        go_back(v, by);
    broadest = std::max(broadest, width);
    before.add(model, model.parts[p], given);
    after.add(model, model.parts[p], model.positions);
  }
}

}  // namespace relievo
