#include <algorithm>
#include <cmath>

#include "kernel/geometry/polygon.h"
#include "relief/join_proposals/roots.h"

namespace relievo {
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

class CapFinder {
 public:
  CapFinder(const LayerGrid& grid, const RingRun& run, int part, int other)
      : grid_(grid), run_(run), part_(part), other_(other) {
    for (int i = 0; i <= root_samples; ++i)
      points_.push_back(run.at(run.length * i / root_samples));
  }

  RootCap find() const {
    const std::vector<Point2> normals = outward_normals();
    const int low = static_cast<int>(root_margin * root_samples);
    const int high = root_samples - low;
    const int tip = find_tip(normals, low, high);
    const Point2 axis = axis_at(tip, normals);
    const auto in_cap = [&](int i) { return dot(normals[i], axis) > std::cos(cap_angle); };
    int first = tip;
    int last = tip;
    while (first > low && in_cap(first - 1)) --first;
    while (last < high && in_cap(last + 1)) ++last;
    const double step = run_.length / root_samples;
    const double room = longest() / std::max(step * (last - first), 1e-9);
    const double keep = std::min(1.0, room);
    return {step * (tip - keep * (tip - first)), step * (tip + keep * (last - tip))};
  }

 private:
  static constexpr int reach = static_cast<int>(smoothing * root_samples);

  double longest() const {
    return (long_cap + roundness() * (round_cap - long_cap)) * std::sqrt(signed_area(*run_.ring));
  }

  double roundness() const {
    const double length = run_.measure.length;
    const double disc = 4 * M_PI * signed_area(*run_.ring) / (length * length);
    return std::clamp((disc - hardly_round) / (fully_round - hardly_round), 0.0, 1.0);
  }

  /// Outer rings have positive area with y down: outwards is to the left of the direction.
  std::vector<Point2> outward_normals() const {
    std::vector<Point2> normals;
    for (int i = 0; i <= root_samples; ++i) {
      const Point2 along =
          unit(points_[std::min(i + reach, root_samples)] - points_[std::max(i - reach, 0)]);
      normals.push_back({along.y, -along.x});
    }
    return normals;
  }

  /// Of a limb what is farthest on its way into the other part, of a round one or one that lies
  /// mostly on the other what is farthest from its free end.
  int find_tip(const std::vector<Point2>& normals, int low, int high) const {
    const double common = static_cast<double>(common_area(grid_, part_, other_));
    const double beside = 1 - common / static_cast<double>(grid_.areas[part_]);
    const double t = beside < least_protrusion ? 1 : roundness();
    const Point2 inwards = way_inwards();
    const auto farthest =
        std::max_element(points_.begin() + low, points_.begin() + high + 1,
                         [&](Point2 a, Point2 b) { return dot(a, inwards) < dot(b, inwards); });
    const auto by_way = static_cast<double>(farthest - points_.begin());
    return static_cast<int>(std::lround((1 - t) * by_way + t * innermost(normals, low, high)));
  }

  int innermost(const std::vector<Point2>& normals, int low, int high) const {
    const std::vector<double> distance = distance_from_free_end(grid_, part_, other_);
    const Mask& mask = grid_.masks[part_];
    int tip = (low + high) / 2;
    double farthest = -1;
    for (int i = low; i <= high; ++i) {
      const Point2 p = grid_.scale * points_[i] - 1.5 * normals[i];
      const int x = static_cast<int>(std::floor(p.x));
      const int y = static_cast<int>(std::floor(p.y));
      if (!mask.has(x, y)) continue;
      const double d = distance[(y - mask.top) * mask.inside.width + x - mask.left];
      if (!std::isfinite(d) || d <= farthest) continue;
      farthest = d;
      tip = i;
    }
    return tip;
  }

  /// The normal at the tip and, where that agrees, the way from what lies beside the other part to
  /// what lies on it.
  Point2 axis_at(int tip, const std::vector<Point2>& normals) const {
    Point2 sum;
    for (int i = std::max(0, tip - reach); i <= std::min(root_samples, tip + reach); ++i)
      sum = sum + normals[i];
    const Point2 normal = unit(sum);
    const Point2 inwards = way_inwards();
    return dot(normal, inwards) > 0.5 ? unit(normal + inwards) : normal;
  }

  Point2 way_inwards() const {
    Point2 inside, beside;
    double n = 0, m = 0;
    for_each_pixel(grid_.masks[part_], [&](int x, int y) {
      const Point2 p{x + 0.5, y + 0.5};
      if (grid_.masks[other_].has(x, y)) {
        inside = inside + p;
        ++n;
      } else {
        beside = beside + p;
        ++m;
      }
    });
    return n > 0 && m > 0 ? unit(1 / n * inside - 1 / m * beside) : Point2{};
  }

  const LayerGrid& grid_;
  const RingRun& run_;
  int part_;
  int other_;
  std::vector<Point2> points_;
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

RootCap find_root_cap(const LayerGrid& grid, const RingRun& run, int part, int other) {
  return CapFinder(grid, run, part, other).find();
}

}  // namespace relievo
