#include "relief/drawing/label_outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "kernel/image/label_arcs.h"

namespace relievo {
namespace {

constexpr int smoothing_rounds = 6;  ///< of (1, 2, 1) / 4: a deviation of 1.7 px
constexpr int centring_rounds = 2;
constexpr double sample_step = 0.5;  ///< px along the normal
constexpr double tolerance = 0.05;   ///< px that a left-out point lies off the chord

using Polyline = std::vector<Point2>;
using CornerKey = std::pair<int, int>;

CornerKey key(PixelCorner corner) { return {corner.y, corner.x}; }

/// How many arcs end at each end of an arc; a closed boundary of its own ends where it began.
std::map<CornerKey, int> count_ends(const std::vector<LabelArc>& arcs) {
  std::map<CornerKey, int> ends;
  for (const LabelArc& arc : arcs) {
    ++ends[key(arc.corners.front())];
    ++ends[key(arc.corners.back())];
  }
  return ends;
}

/// Neighbours of point i; the ends of an open line have themselves.
std::pair<size_t, size_t> neighbours(size_t i, size_t n, bool closed) {
  if (closed) return {(i + n - 1) % n, (i + 1) % n};
  return {i > 0 ? i - 1 : 0, std::min(i + 1, n - 1)};
}

void smooth(Polyline& line, bool closed, int rounds) {
  Polyline next = line;
  for (int round = 0; round < rounds; ++round) {
    for (size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < line.size(); ++i) {
      const auto [before, after] = neighbours(i, line.size(), closed);
      next[i] = 0.25 * line[before] + 0.5 * line[i] + 0.25 * line[after];
    }
    line.swap(next);
  }
}

/// Bilinear value at p, px; pixel centres lie at + 0.5.
double sample(const Image8& image, Point2 p) {
  const double x = std::clamp(p.x - 0.5, 0.0, image.width - 1.0);
  const double y = std::clamp(p.y - 0.5, 0.0, image.height - 1.0);
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, image.width - 1);
  const int y1 = std::min(y0 + 1, image.height - 1);
  const double u = x - x0;
  const double v = y - y0;
  return (1 - v) * ((1 - u) * image.at(x0, y0) + u * image.at(x1, y0)) +
         v * ((1 - u) * image.at(x0, y1) + u * image.at(x1, y1));
}

/// How far along the normal the middle of the ink around p lies; 0 where there is none.
double offset_to_ink(const Image8& ink, Point2 p, Point2 normal, double reach) {
  double weight = 0;
  double moment = 0;
  for (double t = -reach; t <= reach; t += sample_step) {
    const double value = sample(ink, p + t * normal);
    weight += value;
    moment += value * t;
  }
  return weight > 0 ? moment / weight : 0;
}

void move_to_line_centres(Polyline& line, bool closed, const Image8& ink, double reach) {
  Polyline moved = line;
  for (size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < line.size(); ++i) {
    const auto [before, after] = neighbours(i, line.size(), closed);
    const Point2 along = line[after] - line[before];
    const double length = norm(along);
    if (length == 0) continue;
    const Point2 normal{-along.y / length, along.x / length};
    moved[i] = line[i] + offset_to_ink(ink, line[i], normal, reach) * normal;
  }
  line = std::move(moved);
}

/// Lines that leave the image at its edge stay on it.
bool lies_on_edge(const LabelArc& arc, int width, int height) {
  const auto all = [&](auto test) {
    return std::all_of(arc.corners.begin(), arc.corners.end(), test);
  };
  return all([](PixelCorner c) { return c.x == 0; }) ||
         all([](PixelCorner c) { return c.y == 0; }) ||
         all([=](PixelCorner c) { return c.x == width; }) ||
         all([=](PixelCorner c) { return c.y == height; });
}

/// Leaves out points that lie on the chord of those kept, one after the other.
Polyline thinned_out(const Polyline& line) {
  Polyline kept = {line.front()};
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    const Point2 chord = line[i + 1] - kept.back();
    const double length = norm(chord);
    const bool near = length > 0 && length < 4 &&
                      std::abs(cross(chord, line[i] - kept.back())) < tolerance * length;
    if (!near) kept.push_back(line[i]);
  }
  kept.push_back(line.back());
  return kept;
}

class OutlineMaker {
 public:
  OutlineMaker(const Image16& labels, const Image8& ink, double line_width)
      : labels_(labels), ink_(ink), reach_(line_width / 2 + 1), arcs_(trace_label_arcs(labels)) {}

  std::vector<Outline> make() {
    const std::map<CornerKey, int> ends = count_ends(arcs_);
    for (const LabelArc& arc : arcs_)
      lines_.push_back(line_of(arc, arc.closed() && ends.at(key(arc.corners.front())) == 2));
    std::vector<Outline> outlines;
    for (const auto& rings : label_rings(arcs_)) {
      outlines.emplace_back();
      for (const auto& ring : rings) outlines.back().push_back(joined(ring));
      orient_by_nesting(outlines.back());
    }
    return outlines;
  }

 private:
  Polyline line_of(const LabelArc& arc, bool closed) const {
    Polyline line;
    for (const PixelCorner corner : arc.corners)
      line.push_back(Point2{corner.x * 1.0, corner.y * 1.0});
    if (lies_on_edge(arc, labels_.width, labels_.height)) return {line.front(), line.back()};
    if (closed) line.pop_back();
    smooth(line, closed, smoothing_rounds);
    for (int round = 0; round < centring_rounds && !ink_.empty(); ++round) {
      move_to_line_centres(line, closed, ink_, reach_);
      smooth(line, closed, smoothing_rounds / 2);
    }
    if (closed) line.push_back(line.front());
    return thinned_out(line);
  }

  Ring joined(const std::vector<ArcUse>& uses) const {
    Ring ring;
    for (const ArcUse& use : uses) {
      const Polyline& line = lines_[use.arc];
      if (use.forward)
        ring.insert(ring.end(), line.begin(), line.end() - 1);
      else
        ring.insert(ring.end(), line.rbegin(), line.rend() - 1);
    }
    return ring;
  }

  const Image16& labels_;
  const Image8& ink_;
  double reach_;
  std::vector<LabelArc> arcs_;
  std::vector<Polyline> lines_;
};

}  // namespace

std::vector<Outline> label_outlines(const Image16& labels, const Image8& ink, double line_width) {
  return OutlineMaker(labels, ink, line_width).make();
}

}  // namespace relievo
