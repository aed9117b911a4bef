#pragma once

#include <algorithm>
#include <cmath>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"

namespace relievo {

/// A drawing made of anti-aliased ink strokes on white paper.
class InkDrawing {
 public:
  InkDrawing(int width, int height) : rgba_(width, height, 4, 255) {}

  /// An arc of a circle, angles in turns from +x towards +y.
  InkDrawing& arc(Point2 centre, double radius, double from, double to, double width = 4) {
    const int steps = 24 + static_cast<int>(radius);
    for (int k = 0; k < steps; ++k)
      line(on_circle(centre, radius, from + (to - from) * k / steps),
           on_circle(centre, radius, from + (to - from) * (k + 1) / steps), width);
    return *this;
  }

  InkDrawing& circle(Point2 centre, double radius, double width = 4) {
    return arc(centre, radius, 0, 1, width);
  }

  InkDrawing& line(Point2 a, Point2 b, double width = 4) {
    const double reach = width / 2 + 1;
    const auto bound = [&](double v, int n) { return std::clamp(static_cast<int>(v), 0, n - 1); };
    for (int y = bound(std::min(a.y, b.y) - reach, rgba_.height);
         y <= bound(std::max(a.y, b.y) + reach, rgba_.height); ++y)
      for (int x = bound(std::min(a.x, b.x) - reach, rgba_.width);
           x <= bound(std::max(a.x, b.x) + reach, rgba_.width); ++x)
        darken(x, y, width / 2 + 0.5 - distance_to({x + 0.5, y + 0.5}, a, b));
    return *this;
  }

  /// Fills a disc with a colour, under what is drawn later.
  InkDrawing& disc(Point2 centre, double radius, uint8_t red, uint8_t green, uint8_t blue) {
    for (int y = 0; y < rgba_.height; ++y)
      for (int x = 0; x < rgba_.width; ++x) {
        if (distance({x + 0.5, y + 0.5}, centre) > radius) continue;
        rgba_.at(x, y, 0) = red;
        rgba_.at(x, y, 1) = green;
        rgba_.at(x, y, 2) = blue;
      }
    return *this;
  }

  Drawing drawing() const { return {rgba_}; }

  /// The same lines in black on a transparent ground.
  Drawing on_transparent_ground() const {
    Drawing drawing{rgba_};
    for (size_t i = 0; i < rgba_.pixels.size(); i += 4) {
      drawing.rgba.pixels[i + 3] = static_cast<uint8_t>(255 - rgba_.pixels[i]);
      for (size_t c = 0; c < 3; ++c) drawing.rgba.pixels[i + c] = 0;
    }
    return drawing;
  }

  /// As photographed: grey paper, lit unevenly, with grain.
  Drawing photographed() const {
    Drawing drawing{rgba_};
    for (int y = 0; y < rgba_.height; ++y)
      for (int x = 0; x < rgba_.width; ++x) {
        const double light = 0.85 - 0.35 * x / rgba_.width - 0.15 * y / rgba_.height;
        const double grain = ((x * 7919 + y * 104729 + x * y * 31) % 13 - 6) / 255.0;
        for (int c = 0; c < 3; ++c)
          drawing.rgba.at(x, y, c) = static_cast<uint8_t>(
              std::clamp(rgba_.at(x, y, c) * (light + grain) * (1 - 0.06 * c), 0.0, 255.0));
      }
    return drawing;
  }

 private:
  static Point2 on_circle(Point2 centre, double radius, double turn) {
    const double angle = 2 * 3.14159265358979323846 * turn;
    return centre + radius * Point2{std::cos(angle), std::sin(angle)};
  }

  static double distance_to(Point2 p, Point2 a, Point2 b) {
    const double length2 = dot(b - a, b - a);
    const double t = length2 > 0 ? std::clamp(dot(p - a, b - a) / length2, 0.0, 1.0) : 0;
    return distance(p, a + t * (b - a));
  }

  void darken(int x, int y, double coverage) {
    const auto value = static_cast<uint8_t>(255 - 235 * std::clamp(coverage, 0.0, 1.0));
    for (int c = 0; c < 3; ++c) rgba_.at(x, y, c) = std::min(rgba_.at(x, y, c), value);
  }

  Image8 rgba_;
};

}  // namespace relievo
