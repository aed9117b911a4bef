#include "understanding/joins/root_caps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/geometry/moments.h"
#include "kernel/geometry/polygon.h"
#include "understanding/joins/layer_grid.h"
#include "understanding/joins/roots.h"

namespace relievo::understanding {
namespace {

constexpr int root_samples = 200;
/// The cap of a root stays away from its ends by this share of it.
constexpr double root_margin = 0.18;
constexpr double cap_angle = 1;  ///< radians between the normals of the cap and the limb's axis
/// A cap is no longer than this times the root of the limb's area; of round parts, whose necks are
/// narrower than they are, the other.
constexpr double long_cap = 0.65;
constexpr double round_cap = 0.45;
/// The part's area over that of a disc of the same perimeter, from where it counts as round.
constexpr double hardly_round = 0.75;
constexpr double fully_round = 0.95;
constexpr double smoothing = 0.05;  ///< of normals, share of the root to either side
/// A limb's axis is that of what lies within so many times its half width from its end, and is as
/// sure as that is longer than wide, up to this ratio of a tube's standard deviations there.
constexpr double end_reach = 3;
constexpr double tube_ratio = 1.5;
/// Anchors lie within so many grid pixels of the outline; an end moves to one by at most this share
/// of the cap, so that half of it stays.
constexpr double on_outline = 0.5;
constexpr double most_moved = 0.25;

/// The stretches of the ring inside `other`, single samples apart taken together.
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

/// The direction in which a limb ends, and how sure that is, from 0 to 1.
struct LimbAxis {
  Point2 along;
  double trust = 0;
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

  /// Just inside the part, in grid pixels.
  Point2 inside_of(int i) const { return grid_.scale * points_[i] - 1.5 * normals_[i]; }

  /// The sample that is farthest from what lies beside the other part, on ways inside the limb.
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

  /// The main axis of what of the limb is near its end, towards it.
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

  /// The cap, no longer than it may be, and then as much of it to both sides of its tip as it has.
  RootCap trimmed(RootCap cap, double tip) const {
    const double room = longest();
    const double before = std::min(tip - cap.from, std::max(room / 2, room - (cap.to - tip)));
    return {tip - before, std::min(cap.to, tip - before + room)};
  }

  /// The cap with its ends at the nearest anchors, where some are near.
  RootCap anchored(RootCap cap, const std::vector<Point2>& anchors) const {
    const double room = most_moved * (cap.to - cap.from);
    RootCap moved = cap;
    double from_off = room;
    double to_off = room;
    for (const Point2 anchor : anchors) {
      const std::optional<double> at = place_of(anchor);
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

  /// Where along the run a point lies, if on it.
  std::optional<double> place_of(Point2 p) const {
    double least = on_outline / grid_.scale;
    std::optional<double> place;
    for (int i = 0; i < root_samples; ++i) {
      const Point2 side = points_[i + 1] - points_[i];
      const double t =
          std::clamp(dot(p - points_[i], side) / std::max(dot(side, side), 1e-12), 0.0, 1.0);
      const double off = distance(p, points_[i] + t * side);
      if (off >= least) continue;
      least = off;
      place = (i + t) * run_.length / root_samples;
    }
    return place;
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
