#include "understanding/joins/root_caps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/geometry/moments.h"

namespace relievo::understanding {
namespace {

constexpr int root_samples = 200;     ///< steps along the run of a root
constexpr double root_margin = 0.18;  ///< share of the run at each end that a cap avoids
constexpr double cap_angle = 1;       ///< largest angle of a cap's normals to the limb's axis, rad
/// The largest length of a cap, over the square root of the limb's area: of long limbs, and of
/// round parts, whose necks are narrower than they are.
constexpr double long_cap = 0.65;
constexpr double round_cap = 0.45;
/// A part's area over that of a disc with its perimeter: long limbs have at most the first, round
/// parts at least the second.
constexpr double hardly_round = 0.75;
constexpr double fully_round = 0.95;
constexpr double smoothing =
    0.05;  ///< share of the run to either side over which normals are averaged
/// The end of a limb that determines its axis, in multiples of its half width.
constexpr double end_reach = 3;
/// The ratio of standard deviations along and across the axis of that end, from which on the axis
/// is trusted fully.
constexpr double tube_ratio = 1.5;
constexpr double on_outline = 0.5;   ///< largest distance of anchors from the outline, grid pixels
constexpr double most_moved = 0.25;  ///< share of the cap by which an anchor moves an end at most

/// The runs of the ring inside `other`; a single sample outside does not interrupt a run.
std::vector<RingRun> runs_inside(const LayerGrid& grid, const Ring& ring, int other) {
  const RingMeasure m = measure(ring);
  const int count = std::max(16, static_cast<int>(m.length * grid.scale / root_step));
  const double step = m.length / count;
  std::vector<uint8_t> inside(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) inside[i] = grid.has(other, point_at(ring, m, i * step));
  for (int i = 0; i < count; ++i)
    if (inside[(i + count - 1) % count] != 0 && inside[(i + 1) % count] != 0) inside[i] = 1;
  const auto start = std::find(inside.begin(), inside.end(), 0) - inside.begin();
  if (start == count) return {{&ring, m, 0, m.length}};
  std::vector<RingRun> runs;
  for (int i = 0; i < count; ++i) {
    const int at = static_cast<int>(start) + i;
    if (inside[at % count] == 0) continue;
    if (inside[(at + count - 1) % count] == 0) runs.push_back({&ring, m, at * step, 0});
    runs.back().length += step;
  }
  return runs;
}

Point2 unit(Point2 p) {
  const double length = norm(p);
  return length > 0 ? 1 / length * p : Point2{};
}

/// The direction in which a limb ends.
struct LimbAxis {
  Point2 along;      ///< unit vector
  double trust = 0;  ///< in [0, 1]
};

class CapFinder {
 public:
  CapFinder(const LayerGrid& grid, const RingRun& run, int part, int other)
      : grid_(grid), run_(run), part_(part), other_(other) {
    for (int i = 0; i <= root_samples; ++i)
      points_.push_back(run.at(run.length * i / root_samples));
    for (int i = 0; i <= root_samples; ++i) {
      // Outer rings have positive area with y down: outwards is to the left of the direction.
      const Point2 way =
          unit(points_[std::min(i + reach, root_samples)] - points_[std::max(i - reach, 0)]);
      normals_.push_back({way.y, -way.x});
    }
  }

  RootCap find(const std::vector<Point2>& anchors) const {
    const int deepest = innermost();
    const LimbAxis limb = axis_towards(deepest);
    const int tip = static_cast<int>(
        std::lround(limb.trust * farthest(limb.along) + (1 - limb.trust) * deepest));
    const Point2 axis = unit(limb.trust * limb.along + (1 - limb.trust) * normal_around(tip));
    const auto in_cap = [&](int i) { return dot(normals_[i], axis) > std::cos(cap_angle); };
    int first = tip;
    int last = tip;
    while (first > low && in_cap(first - 1)) --first;
    while (last < high && in_cap(last + 1)) ++last;
    const double step = run_.length / root_samples;
    return anchored(trimmed({step * first, step * last}, step * tip), anchors);
  }

 private:
  static constexpr int reach = static_cast<int>(smoothing * root_samples);
  static constexpr int low = static_cast<int>(root_margin * root_samples);
  static constexpr int high = root_samples - low;

  double longest() const {
    return (long_cap + roundness() * (round_cap - long_cap)) * std::sqrt(signed_area(*run_.ring));
  }

  double roundness() const {
    const double length = run_.measure.length;
    const double disc = 4 * M_PI * signed_area(*run_.ring) / (length * length);
    return std::clamp((disc - hardly_round) / (fully_round - hardly_round), 0.0, 1.0);
  }

  Point2 normal_around(int tip) const {
    Point2 sum;
    for (int i = std::max(0, tip - reach); i <= std::min(root_samples, tip + reach); ++i)
      sum = sum + normals_[i];
    return unit(sum);
  }

  /// The sample that is farthest in a direction.
  int farthest(Point2 way) const {
    const auto most =
        std::max_element(points_.begin() + low, points_.begin() + high + 1,
                         [&](Point2 a, Point2 b) { return dot(a, way) < dot(b, way); });
    return static_cast<int>(most - points_.begin());
  }

  /// A point 1.5 grid pixels inside the part, in grid pixels.
  Point2 inside_of(int i) const { return grid_.scale * points_[i] - 1.5 * normals_[i]; }

  /// The sample that is farthest, on ways inside the limb, from the limb's pixels outside the other
  /// part.
  int innermost() const {
    const Mask& mask = grid_.masks[part_];
    const std::vector<double> away =
        distance_inside(mask, [&](int x, int y) { return !grid_.masks[other_].has(x, y); });
    int tip = (low + high) / 2;
    double most = -1;
    for (int i = low; i <= high; ++i) {
      const Point2 p = inside_of(i);
      const int x = static_cast<int>(std::floor(p.x));
      const int y = static_cast<int>(std::floor(p.y));
      if (!mask.has(x, y)) continue;
      const double d = away[mask_index(mask, x, y)];
      if (!std::isfinite(d) || d <= most) continue;
      most = d;
      tip = i;
    }
    return tip;
  }

  /// The main axis of the limb near the end at a sample, directed towards that end.
  LimbAxis axis_towards(int end) const {
    const Mask& mask = grid_.masks[part_];
    const Point2 from = inside_of(end);
    const std::vector<double> away = distance_inside(mask, [&](int x, int y) {
      return x == static_cast<int>(std::floor(from.x)) && y == static_cast<int>(std::floor(from.y));
    });
    const double near = end_reach * thickness_at(grid_, part_, other_);
    Moments moments;
    for_each_pixel(mask, [&](int x, int y) {
      if (away[mask_index(mask, x, y)] <= near) moments.add(Point2{x + 0.5, y + 0.5} - from);
    });
    const MainAxes axes = moments.axes();
    if (axes.longer == 0) return {};
    const double agreement = dot(axes.along, unit(-1 * axes.centre));
    const double ratio = std::sqrt(axes.longer / std::max(axes.shorter, 1e-9));
    const double tube = std::clamp((ratio - 1) / (tube_ratio - 1), 0.0, 1.0);
    return {agreement < 0 ? -1 * axes.along : axes.along, tube * tube * agreement * agreement};
  }

  /// Shortens a cap to the allowed length, equally to both sides of its tip where possible.
  RootCap trimmed(RootCap cap, double tip) const {
    const double room = longest();
    const double before = std::min(tip - cap.from, std::max(room / 2, room - (cap.to - tip)));
    return {tip - before, std::min(cap.to, tip - before + room)};
  }

  /// Moves the ends of a cap to the nearest anchors, where some are near.
  RootCap anchored(RootCap cap, const std::vector<Point2>& anchors) const {
    const double room = most_moved * (cap.to - cap.from);
    RootCap moved = cap;
    double from_off = room;
    double to_off = room;
    for (const Point2 anchor : anchors) {
      const std::optional<double> at = arc_length_of(anchor);
      if (!at) continue;
      if (std::abs(*at - cap.from) < from_off) {
        from_off = std::abs(*at - cap.from);
        moved.from = *at;
      }
      if (std::abs(*at - cap.to) < to_off) {
        to_off = std::abs(*at - cap.to);
        moved.to = *at;
      }
    }
    return moved;
  }

  /// The arc length along the run at which a point lies on it.
  std::optional<double> arc_length_of(Point2 p) const {
    double least = on_outline / grid_.scale;
    std::optional<double> found;
    for (int i = 0; i < root_samples; ++i) {
      const Point2 side = points_[i + 1] - points_[i];
      const double t =
          std::clamp(dot(p - points_[i], side) / std::max(dot(side, side), 1e-12), 0.0, 1.0);
      const double off = distance(p, points_[i] + t * side);
      if (off >= least) continue;
      least = off;
      found = (i + t) * run_.length / root_samples;
    }
    return found;
  }

  const LayerGrid& grid_;
  const RingRun& run_;
  int part_;
  int other_;
  std::vector<Point2> points_;
  std::vector<Point2> normals_;  ///< outwards, smoothed
};

}  // namespace

std::vector<RingRun> runs_inside(const LayerGrid& grid, const Outline& outline, int other) {
  std::vector<RingRun> runs;
  for (const Ring& ring : outline)
    if (signed_area(ring) > 0)
      for (RingRun& run : runs_inside(grid, ring, other)) runs.push_back(std::move(run));
  std::stable_sort(runs.begin(), runs.end(),
                   [](const RingRun& a, const RingRun& b) { return a.length > b.length; });
  return runs;
}

RootCap find_root_cap(const LayerGrid& grid, const RingRun& run, int part, int other,
                      const std::vector<Point2>& anchors) {
  return CapFinder(grid, run, part, other).find(anchors);
}

}  // namespace relievo::understanding
