#include "relief/finish/ink_ribbons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "relief/finish/floor.h"

namespace relievo::relief {
namespace {

constexpr double ribbon_lift = 0.002;  ///< of the canvas: height of ribbons above parts below
constexpr double steepest = 3;         ///< widths by which a ribbon rises to the parts below
constexpr int tile_margin = 2;         ///< px around a ribbon, for filtering
constexpr int tile_side = 24;          ///< px, shorter side of most tiles

using Rung = std::array<Point3, 2>;

/// Cuts runs of rungs into ribbons.
class RibbonCutter {
 public:
  RibbonCutter(const Model& surface, ImageSize drawing)
      : scale_(drawing.width / surface.width), height_(surface.height), drawing_(drawing) {}

  /// Adds a rung to the ribbon that is open.
  void add(const Rung& rung) {
    Box2 grown = grow(box_, rung);
    const Point2 sides = grown.max - grown.min;
    const double breadth = scale_ * distance(flat(rung[0]), flat(rung[1]));
    if (rungs_.size() > 1 && std::min(sides.x, sides.y) > tile_side + breadth) {
      const Rung last = rungs_.back();
      finish();
      rungs_ = {last};
      grown = grow(grow({}, last), rung);
    }
    rungs_.push_back(rung);
    box_ = grown;
  }

  void finish() {
    if (rungs_.size() > 1) ribbons_.push_back({rungs_, pixels_around(box_)});
    rungs_.clear();
    box_ = {};
  }

  std::vector<InkRibbon> take() && { return std::move(ribbons_); }

 private:
  static Point2 flat(Point3 p) { return {p.x, p.y}; }

  Box2 grow(Box2 box, const Rung& rung) const {
    for (const Point3& p : rung) box.add(Point2{scale_ * p.x, scale_ * (height_ - p.y)});
    return box;
  }

  PixelBox pixels_around(const Box2& box) const {
    const auto low = [](double v) {
      return std::max(0, static_cast<int>(std::floor(v)) - tile_margin);
    };
    const auto high = [](double v, int most) {
      return std::min(most, static_cast<int>(std::floor(v)) + tile_margin + 1);
    };
    return {low(box.min.x), low(box.min.y), high(box.max.x, drawing_.width),
            high(box.max.y, drawing_.height)};
  }

  double scale_;  ///< px of the drawing per px of the canvas
  double height_;
  ImageSize drawing_;
  std::vector<Rung> rungs_;
  Box2 box_;
  std::vector<InkRibbon> ribbons_;
};

/// Places a rung over what the floor has behind it, of a height `below`.
Rung rung_at(const OutlinePoint& p, const Model& surface, double below) {
  const Point3 inner = surface.positions[p.vertex];
  const Point2 outer = p.place + p.outside * p.out;
  const double lift = ribbon_lift * std::max(surface.width, surface.height);
  const double most = inner.z + steepest * (p.inside + p.outside);
  return {inner, {outer.x, outer.y, std::clamp(below + lift, inner.z, most)}};
}

}  // namespace

std::vector<InkRibbon> make_ribbons(const ContourInk& ink, const Model& surface, ImageSize drawing,
                                    bool over_nothing) {
  constexpr double nothing = std::numeric_limits<float>::lowest();
  RibbonCutter cutter(surface, drawing);
  Floor floor(surface);
  size_t next = 0;
  for (size_t part = 0; part < surface.parts.size(); ++part) {
    for (; next < ink.lines.size() && ink.lines[next].part == static_cast<int>(part); ++next) {
      std::vector<OutlinePoint> points = ink.lines[next].points;
      if (ink.lines[next].closed) points.push_back(points.front());
      for (const OutlinePoint& p : points) {
        const Point2 outer = p.place + p.outside * p.out;
        const double below =
            floor.height_at({outer.x / surface.width, 1 - outer.y / surface.height});
        if (over_nothing || below != nothing)
          cutter.add(rung_at(p, surface, below));
        else
          cutter.finish();
      }
      cutter.finish();
    }
    floor.add(surface, surface.parts[part]);
  }
  return std::move(cutter).take();
}

}  // namespace relievo::relief
