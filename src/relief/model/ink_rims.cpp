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
#include "kernel/image/image_size.h"
#include "kernel/meshing/segment_grid.h"
#include "relief/model/fill_triangle.h"

namespace relievo {
namespace {

constexpr double upright = 1e-6;       ///< z of normals at outlines, at most
constexpr double widest_ink = 0.03;    ///< of the drawing's diagonal
constexpr double least_contrast = 40;  ///< between ink and the paint beside it, of 255
constexpr double inked_share = 0.5;    ///< of what is seen of a part's outline
constexpr double probe = 2;            ///< px, where to look on both sides of an outline
constexpr double blurred = 1.5;        ///< px beside ink that hold some of it
constexpr double broad_share = 0.8;   ///< of the widths of ink nearby lie below the one that counts
constexpr double nearby = 4;          ///< widths of ink
constexpr double reach_of_ink = 6;    ///< widths of ink, up to where surfaces give way
constexpr double deepest_ink = 0.5;   ///< of the squared height in the middle of a limb, at most
constexpr double round_again = 4;     ///< squared heights of the ink's end, where nothing changes
constexpr double edge_of_line = 0.5;  ///< widths of ink, how high the line's own edge is
constexpr double above_others = 0.002;  ///< of the canvas, how far ink keeps above what lies below
constexpr int longest_floor = 1024;     ///< px, of the view in which heights below are taken

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
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    const auto darkest = std::min_element(values.begin(), half);
    const double paint = *std::max_element(darkest, values.end());
    if (paint - *darkest < least_contrast) return std::nullopt;
    const double between = 0.5 * (paint + *darkest);
    const auto end =
        std::find_if(darkest, values.end(), [between](double v) { return v > between; });
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
std::vector<RimVertex> find_rim(const Model& model, const RimView& view, int part,
                                const std::vector<int>& vertices) {
  std::vector<RimVertex> rim;
  const double widest = widest_ink * view.scale() * norm(Point2{model.width, model.height});
  for (const int v : vertices) {
    if (std::abs(model.normals[v].z) > upright || !view.ends_here(v, part)) continue;
    const Point3 p = model.positions[v];
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

/// The width of ink along most of a part's outline, canvas px; 0 where most has none.
double common_width(const std::vector<RimVertex>& rim) {
  std::vector<double> widths;
  for (const RimVertex& v : rim)
    if (v.width > 0) widths.push_back(v.width);
  const double least = inked_share * static_cast<double>(rim.size());
  return widths.empty() || static_cast<double>(widths.size()) < least
             ? 0
             : quantile(widths, broad_share);
}

/// Finds the points near a place. Precondition: there are points.
class NearPoints {
 public:
  explicit NearPoints(std::vector<Point2> points)
      : points_(std::move(points)), grid_(box(), points_.size()) {
    grid_.build(points_.size(), [this](size_t i) { return std::pair(points_[i], points_[i]); });
  }

  /// Calls visit(index, distance) for all closer than `radius`.
  template <class Visit>
  void for_each(Point2 place, double radius, Visit visit) const {
    grid_.for_cells(place, place, radius, [&](size_t cell) {
      for (const int* i = grid_.begin(cell); i != grid_.end(cell); ++i) {
        const double d = distance(points_[*i], place);
        if (d < radius) visit(static_cast<size_t>(*i), d);
      }
    });
  }

 private:
  Box2 box() const {
    Box2 box;
    for (const Point2 p : points_) box.add(p);
    return box;
  }

  std::vector<Point2> points_;
  SegmentGrid grid_;
};

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
  double rim = 0;       ///< px, the height of the rim beside it
  double f = 0;         ///< px, its own height over that
};

/// Lets the surface of one part begin where its ink ends.
class RimFlattener {
 public:
  RimFlattener(const Model& model, const std::vector<int>& vertices, std::vector<RimVertex> rim,
               double width)
      : reach_(reach_of_ink * width), rim_(std::move(rim)), near_rim_(places_of(rim_)) {
    find_band(model, vertices);
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
      for_rim(near.place, near.distance, [&](const RimVertex& v, double weight) {
        u += weight * v.u;
        fade += weight * v.fade;
        width += weight * v.width;
      });
      const double t = near.distance / reach_;
      const double left = near.f - lowered(near.f, u, edge_of_line * width);
      const double drop = fade * (1 - t * t) * (1 - t * t) * left;
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

  void find_band(const Model& model, const std::vector<int>& vertices) {
    for (const int v : vertices) {
      const Point3 p = model.positions[v];
      BandVertex near{v, {p.x, p.y}, reach_};
      near_rim_.for_each(near.place, reach_,
                         [&](size_t, double d) { near.distance = std::min(near.distance, d); });
      if (near.distance >= reach_) continue;
      for_rim(near.place, near.distance,
              [&](const RimVertex& r, double weight) { near.rim += weight * r.z; });
      near.f = std::max(0.0, p.z - near.rim);
      band_.push_back(near);
    }
  }

  /// Visits the rim beside a place with weights that add up to 1.
  template <class Visit>
  void for_rim(Point2 place, double nearest, Visit visit) const {
    const auto weight = [](double d) { return 1 / ((d * d + 0.01) * (d * d + 0.01)); };
    const double radius = 3 * nearest + 1;
    double sum = 0;
    near_rim_.for_each(place, radius, [&](size_t, double d) { sum += weight(d); });
    near_rim_.for_each(place, radius, [&](size_t i, double d) { visit(rim_[i], weight(d) / sum); });
  }

  void smooth_widths() {
    std::vector<double> smooth;
    for (RimVertex& v : rim_) {
      std::vector<double> widths;
      double all = 0;
      near_rim_.for_each(v.place, nearby * reach_ / reach_of_ink, [&](size_t i, double) {
        ++all;
        if (rim_[i].width > 0) widths.push_back(rim_[i].width);
      });
      const double share = std::clamp(2 * static_cast<double>(widths.size()) / all - 0.5, 0.0, 1.0);
      v.fade = share * share * (3 - 2 * share);
      smooth.push_back(widths.empty() ? 0 : quantile(widths, broad_share));
    }
    for (size_t i = 0; i < rim_.size(); ++i) rim_[i].width = smooth[i];
  }

  /// Where f^2 is about s t at a distance t from the rim, s times the width of the ink.
  double u_at_end(const RimVertex& v, const NearPoints& near_band) const {
    double sum = 0;
    double weight = 0;
    double most = 0;
    near_band.for_each(v.place, nearby * v.width, [&](size_t i, double) {
      const BandVertex& near = band_[i];
      most = std::max(most, near.f * near.f);
      if (near.distance < 0.4 * v.width || near.distance > 3 * v.width) return;
      sum += near.f * near.f;
      weight += near.distance;
    });
    return weight > 0 ? std::min(v.width * sum / weight, deepest_ink * most) : 0;
  }

  double reach_;
  std::vector<RimVertex> rim_;
  NearPoints near_rim_;
  std::vector<BandVertex> band_;
};

/// The greatest height of the parts so far, on a small view of the canvas.
class Floor {
 public:
  explicit Floor(const Model& model)
      : size_(fitted_size(model.width, model.height, longest_floor)),
        height_(size_.width, size_.height, 1, std::numeric_limits<float>::lowest()) {}

  void add(const Model& model, const ModelPart& part) {
    for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      const auto [a, b, c] = corners_on_image(model, t, size_);
      const double area = cross(b - a, c - a);
      const auto z = [&](size_t k) { return model.positions[model.triangles[t][k]].z; };
      for_each_pixel_inside({a, b, c}, size_, [&, a = a, b = b, c = c](int x, int y) {
        const Point2 p{x + 0.5, y + 0.5};
        const double v = cross(p - a, c - a) / area;
        const double w = cross(b - a, p - a) / area;
        float& most = height_.at(x, y);
        most = std::max(most, static_cast<float>((1 - v - w) * z(0) + v * z(1) + w * z(2)));
      });
    }
  }

  /// The greatest height around a vertex, lowest() where there is nothing.
  double at(Point2 uv) const {
    const int x = static_cast<int>(std::floor(uv.x * size_.width - 0.5));
    const int y = static_cast<int>(std::floor(uv.y * size_.height - 0.5));
    float most = std::numeric_limits<float>::lowest();
    for (const int u : {x, x + 1})
      for (const int v : {y, y + 1})
        most = std::max(most, height_.at(std::clamp(u, 0, size_.width - 1),
                                         std::clamp(v, 0, size_.height - 1)));
    return most;
  }

 private:
  ImageSize size_;
  ImageF height_;
};

}  // namespace

void narrow_inked_rims(Model& model, const Drawing& drawing) {
  if (drawing.rgba.empty()) return;
  const RimView view(model, drawing.rgba);
  const double lift = above_others * std::max(model.width, model.height);
  Floor floor(model);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const std::vector<int> vertices = vertices_of(model, model.parts[p]);
    std::vector<RimVertex> rim = find_rim(model, view, static_cast<int>(p), vertices);
    const double width = common_width(rim);
    if (width > 0)
      for (const auto& [v, drop] : RimFlattener(model, vertices, std::move(rim), width).drops()) {
        double& z = model.positions[v].z;
        z = std::max(z - drop, std::min(z, floor.at(model.uvs[v]) + lift));
      }
    floor.add(model, model.parts[p]);
  }
}

}  // namespace relievo
