#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/compose.h"
#include "kernel/image/image_size.h"
#include "kernel/meshing/segment_grid.h"
#include "relief/finish/fill_triangle.h"

namespace relievo::relief {

/// Finds the points of a rim near a place, and extends values at them to the places beside it.
class BesideRim {
 public:
  /// `reach`: canvas px. Precondition: there are points.
  BesideRim(std::vector<Point2> rim, double reach)
      : rim_(std::move(rim)),
        reach_(reach),
        grid_(rim_.size(), [this](size_t i) { return std::pair(rim_[i], rim_[i]); }) {}

  /// Calls visit(index, distance) for all points closer to a place than `radius`.
  template <class Visit>
  void for_each_within(Point2 place, double radius, Visit visit) const {
    grid_.for_each_near(place, place, radius, [&](int i) {
      const double d = distance(rim_[i], place);
      if (d < radius) visit(static_cast<size_t>(i), d);
    });
  }

  /// Returns how far the rim is looked for, canvas px.
  double reach() const { return reach_; }

  /// Returns the distance to the rim, `reach` at most.
  double distance_to(Point2 place) const {
    double nearest = reach_;
    for (double radius = reach_ / 16; radius <= reach_ && nearest == reach_; radius *= 2)
      for_each_within(place, radius, [&](size_t, double d) { nearest = std::min(nearest, d); });
    return nearest;
  }

  /// Calls visit(index, weight) for the points of the rim beside a place, whose distance `nearest`
  /// from the rim is below `reach`. The weights add up to 1 and vary smoothly with the place.
  template <class Visit>
  void for_each(Point2 place, double nearest, Visit visit) const {
    const double radius = 1.5 * nearest + 1;
    const auto weight = [radius](double d) {
      const double inside = 1 - d / radius;
      return inside * inside / ((d * d + 0.01) * (d * d + 0.01));
    };
    double sum = 0;
    for_each_within(place, radius, [&](size_t, double d) { sum += weight(d); });
    for_each_within(place, radius, [&](size_t i, double d) { visit(i, weight(d) / sum); });
  }

  /// Returns a smooth weight, 1 at the rim and 0 at `reach`.
  double share_at(double distance) const { return share_within(distance, reach_); }

  /// The same for another reach.
  static double share_within(double distance, double reach) {
    const double t = std::min(1.0, distance / reach);
    return (1 - t * t) * (1 - t * t);
  }

 private:
  std::vector<Point2> rim_;
  double reach_;
  SegmentGrid grid_;
};

/// A drawing and the parts that the model shows on its pixels.
class RimView {
 public:
  RimView(const Model& model, const Image8& rgba)
      : model_(model),
        rgba_(rgba),
        scale_(rgba.width / model.width),
        front_(front_parts(model, {rgba.width, rgba.height})) {}

  /// Returns the pixels of the drawing per pixel of the canvas.
  double scale() const { return scale_; }

  /// Returns a vertex's position on the drawing, moved by `by` pixels inwards from its outline.
  Point2 inwards(int vertex, double by) const {
    const Point2 uv = model_.uvs[vertex];
    const Point3 n = model_.normals[vertex];
    const double length = std::max(1e-12, norm(Point2{n.x, n.y}));
    return {uv.x * rgba_.width - by * n.x / length, uv.y * rgba_.height + by * n.y / length};
  }

  /// Returns the part seen at a pixel, counted from 1; 0 on paper.
  int part_at(Point2 p) const {
    const int x = static_cast<int>(std::floor(p.x));
    const int y = static_cast<int>(std::floor(p.y));
    const bool on = x >= 0 && y >= 0 && x < front_.width && y < front_.height;
    return on ? front_.at(x, y) : 0;
  }

  /// Returns whether the part, counted from 0, is seen on one side of the vertex and no part in
  /// front of it on the other.
  bool ends_here(int vertex, int part) const {
    return part_at(inwards(vertex, probe)) == part + 1 && part_at(inwards(vertex, -probe)) <= part;
  }

  /// Measures the width of the ink from a vertex inwards, px of the drawing, `widest` at most.
  /// Returns nothing unless there is ink with paint beside it.
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
  /// Returns the brightness of a pixel, 0 to 255.
  double brightness(Point2 p) const {
    const int x = std::clamp(static_cast<int>(p.x), 0, rgba_.width - 1);
    const int y = std::clamp(static_cast<int>(p.y), 0, rgba_.height - 1);
    const uint8_t* c = &rgba_.at(x, y);
    return (on_paper(c[0], c[3]) + on_paper(c[1], c[3]) + on_paper(c[2], c[3])) / 3.0;
  }

  // Tuned on the samples.
  static constexpr double least_contrast = 40;  ///< between ink and the paint beside it, of 255
  static constexpr double paint_share = 0.35;   ///< least contrast of paint, of the greatest
  static constexpr double level_share = 0.1;    ///< variation of paint, of its contrast to ink
  static constexpr double probe = 2;  ///< px from the outline at which parts are looked up
  static constexpr std::ptrdiff_t antialiased = 3;  ///< px inside an outline that may hold paper

  const Model& model_;
  const Image8& rgba_;
  double scale_;
  Image16 front_;
};

}  // namespace relievo::relief
