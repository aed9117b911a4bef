#include "understanding/lines/stroke_ends.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "kernel/geometry/polyline.h"
#include "kernel/image/morphology.h"

namespace relievo::understanding {
namespace {

constexpr double straight_on = 40 * std::numbers::pi / 180;  ///< rad, largest turn of a stroke
constexpr double turn_off = 50 * std::numbers::pi / 180;     ///< rad, least turn to the other line

/// Pixels at one number of steps from an end.
using Front = std::vector<int>;

double angle(Point2 a, Point2 b) { return std::abs(turn_between(a, b)); }

/// Follows strokes from their ends, in steps to neighbouring pixels.
class StrokeWalk {
 public:
  StrokeWalk(const Image8& thinned, int reach, double longest)
      : thinned_(thinned),
        visited_(thinned.width, thinned.height, 1),
        reach_(static_cast<size_t>(reach)),
        longest_(longest) {}

  /// Returns the end at a pixel; nothing where its stroke is not longer than the reach.
  std::optional<StrokeEnd> from(int end) {
    const std::optional<StrokeEnd> found = walk(end);
    for (const int i : touched_) visited_.pixels[i] = 0;
    touched_.clear();
    return found;
  }

 private:
  std::optional<StrokeEnd> walk(int end) {
    visit(end);
    std::vector<Point2> way = {point(end)};
    double length = 0;
    int hidden_side = 0;
    for (Front front = next({end}); !front.empty() && length < longest_; front = next(front)) {
      std::vector<Front> branches = pieces(front);
      if (branches.size() > 1) branches = long_branches(branches);
      if (branches.size() == 2)
        hidden_side = find_hidden_side(way, middle(branches[0]), middle(branches[1]));
      if (branches.size() != 1) break;
      front = branches[0];
      length += distance(way.back(), middle(front));
      way.push_back(middle(front));
    }
    if (way.size() <= reach_) return std::nullopt;
    const Point2 inwards = way[reach_] - way[0];
    return StrokeEnd{way[0], (1 / norm(inwards)) * inwards, length, hidden_side};
  }

  /// Returns the side of a stroke, which has come this way, on which the other of two branches
  /// lies; 0 where neither branch continues the stroke or the other does not turn off.
  int find_hidden_side(const std::vector<Point2>& way, Point2 first, Point2 second) const {
    if (way.size() <= reach_) return 0;
    const Point2 forwards = way.back() - way[way.size() - 1 - reach_];
    Point2 ahead = first - way.back();
    Point2 aside = second - way.back();
    if (angle(forwards, aside) < angle(forwards, ahead)) std::swap(ahead, aside);
    if (angle(forwards, ahead) > straight_on || angle(forwards, aside) < turn_off) return 0;
    return cross(forwards, aside) > 0 ? 1 : -1;
  }

  /// Returns the branches that continue for the reach, each as its last front.
  std::vector<Front> long_branches(const std::vector<Front>& branches) {
    std::vector<Front> found;
    for (Front front : branches) {
      Front last = front;
      for (size_t step = 0; step < reach_ && !front.empty(); ++step) {
        last = front;
        front = next(front);
      }
      if (!front.empty()) found.push_back(front);
    }
    return found;
  }

  /// Divides a front into its connected pieces.
  std::vector<Front> pieces(const Front& front) const {
    std::vector<Front> found;
    for (const int i : front) {
      const auto beside = [&](int j) {
        const Point2 d = point(i) - point(j);
        return std::max(std::abs(d.x), std::abs(d.y)) <= 1;
      };
      const auto piece = std::find_if(found.begin(), found.end(), [&](const Front& other) {
        return std::any_of(other.begin(), other.end(), beside);
      });
      if (piece == found.end())
        found.push_back({i});
      else
        piece->push_back(i);
    }
    return found;
  }

  /// Returns the unvisited neighbours of a front and marks them as visited.
  Front next(const Front& front) {
    Front found;
    for (const int i : front) {
      const int x = i % thinned_.width;
      const int y = i / thinned_.width;
      for (int v = std::max(0, y - 1); v <= std::min(thinned_.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(thinned_.width - 1, x + 1); ++u)
          if (thinned_.at(u, v) != 0 && visited_.at(u, v) == 0) {
            found.push_back(v * thinned_.width + u);
            visit(found.back());
          }
    }
    return found;
  }

  void visit(int i) {
    visited_.pixels[i] = 1;
    touched_.push_back(i);
  }

  Point2 point(int i) const {
    const int y = i / thinned_.width;
    return {i - y * thinned_.width + 0.5, y + 0.5};
  }

  Point2 middle(const Front& front) const {
    Point2 sum;
    for (const int i : front) sum = sum + point(i);
    return (1.0 / static_cast<double>(front.size())) * sum;
  }

  const Image8& thinned_;
  Image8 visited_;
  std::vector<int> touched_;
  size_t reach_;
  double longest_;
};

/// Returns whether a stroke ends at a pixel inside the picture: its one or two neighbours lie
/// together.
bool is_end(const Image8& thinned, int i) {
  const uint32_t ring = ring_around(&thinned.pixels[i], thinned.width);
  return runs_in_ring(ring) == 1 && std::popcount(ring) <= 2;
}

}  // namespace

std::vector<StrokeEnd> find_stroke_ends(const Image8& thinned, double line_width, double longest) {
  StrokeWalk walk(thinned, static_cast<int>(std::lround(2 * line_width)) + 3, longest);
  std::vector<StrokeEnd> ends;
  for (int y = 1; y + 1 < thinned.height; ++y)
    for (int x = 1; x + 1 < thinned.width; ++x) {
      const int i = y * thinned.width + x;
      if (thinned.pixels[i] == 0 || !is_end(thinned, i)) continue;
      if (const auto end = walk.from(i)) ends.push_back(*end);
    }
  return ends;
}

}  // namespace relievo::understanding
