#include "relief/completion/contour_gaps.h"

#include <Eigen/Dense>
#include <algorithm>

#include "kernel/base/cyclic_runs.h"

namespace relievo {
namespace {

constexpr size_t noise_sides = 4;
constexpr double window_share = 0.08;
constexpr size_t min_window = 8;
constexpr size_t max_window = 40;
/// Where fewer points are known, a straight line is fitted.
constexpr size_t parabola_points = 12;

/// A maximal run of equal values on a circle.
struct Run {
  size_t first = 0;
  size_t count = 0;
};

/// Runs of `value`; none where the whole circle has one value.
std::vector<Run> runs_of(const std::vector<uint8_t>& circle, uint8_t value) {
  std::vector<Run> runs;
  const size_t n = circle.size();
  const auto same = [&](size_t i, size_t j) { return circle[i] == circle[j]; };
  for_each_run(n, same, [&](size_t first, size_t count) {
    if (circle[first] == value && count < n) runs.push_back({first, count});
  });
  return runs;
}

void drop_short_runs(std::vector<uint8_t>& circle, uint8_t value) {
  for (const Run& run : runs_of(circle, value))
    if (run.count < noise_sides)
      for (size_t i = 0; i < run.count; ++i)
        circle[(run.first + i) % circle.size()] = static_cast<uint8_t>(1 - value);
}

/// The contour that ends beside a gap: from `begin` on, `count` sides away from the gap.
struct Lead {
  size_t begin = 0;
  size_t count = 0;
  bool backwards = false;  ///< against the direction of the ring
};

std::vector<Point2> lead_points(const LabelRing& ring, const Lead& lead) {
  std::vector<Point2> points;
  const size_t n = ring.size();
  for (size_t i = 0; i < lead.count; ++i)
    points.push_back(ring.sides[(lead.begin + (lead.backwards ? n * 2 - i : i)) % n]);
  return points;
}

/// Position and direction, away from the first point, of the parabola that fits the points best.
DirectedPoint fit_end(const std::vector<Point2>& points) {
  const int terms = points.size() >= parabola_points ? 3 : 2;
  Eigen::MatrixXd A(points.size(), terms);
  Eigen::MatrixXd b(points.size(), 2);
  double s = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (i > 0) s += distance(points[i - 1], points[i]);
    const auto row = static_cast<Eigen::Index>(i);
    for (int k = 0; k < terms; ++k) A(row, k) = k == 0 ? 1 : A(row, k - 1) * s;
    b(row, 0) = points[i].x;
    b(row, 1) = points[i].y;
  }
  const Eigen::MatrixXd fit = (A.transpose() * A).ldlt().solve(A.transpose() * b);
  const Point2 slope{fit(1, 0), fit(1, 1)};
  const double length = norm(slope);
  return {{fit(0, 0), fit(0, 1)}, length > 1e-9 ? (1 / length) * slope : Point2{1, 0}};
}

size_t window(const LabelRing& ring) {
  const auto share = static_cast<size_t>(window_share * static_cast<double>(ring.size()));
  return std::clamp(share, min_window, max_window);
}

/// How many sides beside the gap are left out, given the length of the known run.
size_t trimmed(size_t known) { return std::min(junction_sides, (known - 2) / 2); }

void find_ends(const LabelRing& ring, size_t before, size_t after, ContourGap& gap) {
  const size_t n = ring.size();
  const size_t longest = window(ring);
  const size_t skip_before = trimmed(before);
  const size_t skip_after = trimmed(after);
  const Lead lead_in{(gap.first + n - 1 - skip_before) % n, std::min(longest, before - skip_before),
                     true};
  const Lead lead_out{(gap.first + gap.count + skip_after) % n,
                      std::min(longest, after - skip_after), false};
  gap.from = fit_end(lead_points(ring, lead_in));
  gap.from.direction = -1.0 * gap.from.direction;
  gap.to = fit_end(lead_points(ring, lead_out));
}

}  // namespace

KnownContour find_gaps(const LabelRing& ring, std::vector<uint8_t> may_be_hidden) {
  KnownContour known;
  drop_short_runs(may_be_hidden, 1);
  drop_short_runs(may_be_hidden, 0);
  const std::vector<Run> runs = runs_of(may_be_hidden, 1);
  known.nothing = runs.empty() && !may_be_hidden.empty() && may_be_hidden[0] == 1;
  const size_t n = ring.size();
  for (size_t k = 0; k < runs.size(); ++k) {
    const Run& run = runs[k];
    const Run& previous = runs[(k + runs.size() - 1) % runs.size()];
    const Run& next = runs[(k + 1) % runs.size()];
    ContourGap gap{run.first, run.count, {}, {}};
    // With a single gap the known run before it and after it are the same.
    const size_t before = (run.first + 2 * n - previous.first - previous.count) % n;
    const size_t after = (next.first + 2 * n - run.first - run.count) % n;
    find_ends(ring, before == 0 ? n - run.count : before, after == 0 ? n - run.count : after, gap);
    known.gaps.push_back(gap);
  }
  known.hidden = std::move(may_be_hidden);
  return known;
}

std::vector<Point2> bridge_gaps(const LabelRing& ring, const KnownContour& known) {
  std::vector<Point2> bridged;
  const size_t n = ring.size();
  const size_t start = known.gaps.empty() ? 0 : known.gaps.front().first;
  size_t gap = 0;
  for (size_t i = 0; i < n;) {
    const size_t side = (start + i) % n;
    if (known.hidden[side] == 0) {
      bridged.push_back(ring.sides[side]);
      ++i;
      continue;
    }
    const ContourGap& g = known.gaps[gap++];
    const std::vector<Point2> arc = smooth_arc(g.from, g.to, 1.0);
    bridged.insert(bridged.end(), arc.begin(), arc.end());
    i += g.count;
  }
  return bridged;
}

}  // namespace relievo
