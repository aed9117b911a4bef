#include "understanding/completion/contour_gaps.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "kernel/base/cyclic_runs.h"
#include "kernel/base/disjoint_sets.h"

namespace relievo::understanding {
namespace {

constexpr size_t noise_sides = 4;
constexpr double window_share = 0.08;
constexpr size_t min_window = 8;
constexpr size_t max_window = 40;
/// Where fewer points are known, a straight line is fitted.
constexpr size_t parabola_points = 12;
constexpr double max_turn = 1.35 * std::numbers::pi;  ///< of an arc across a gap
constexpr double too_far = std::numeric_limits<double>::infinity();
constexpr size_t most_gaps = 6;  ///< of a part in several pieces, of which all ways are tried

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

/// A gap among those of all rings.
struct RingGap {
  size_t ring = 0;
  size_t gap = 0;
};

/// How a contour goes on across a gap.
struct GapLink {
  RingGap from;
  RingGap to;
  size_t next = 0;  ///< link at the end of the known contour after it
};

double bending(const DirectedPoint& from, const DirectedPoint& to) {
  if (std::abs(turning(from, to)) > max_turn) return too_far;
  const Point2 chord = to.at - from.at;
  return bend_energy(turn_between(from.direction, chord), turn_between(chord, to.direction));
}

/// Whether contours that go on from every gap at the one in that order make one of all rings.
bool connects(const std::vector<RingGap>& gaps, const std::vector<size_t>& order, size_t rings) {
  DisjointSets pieces(static_cast<int>(rings));
  for (size_t i = 0; i < gaps.size(); ++i)
    pieces.unite(static_cast<int>(gaps[i].ring), static_cast<int>(gaps[order[i]].ring));
  const int first = pieces.find(static_cast<int>(gaps[0].ring));
  return std::all_of(gaps.begin(), gaps.end(), [&](const RingGap& gap) {
    return pieces.find(static_cast<int>(gap.ring)) == first;
  });
}

/// At which gap the contour goes on from each, so that all pieces are in one and bend least.
/// Nothing where every way turns too far. O(gaps!).
std::optional<std::vector<size_t>> least_bent(const std::vector<RingGap>& gaps,
                                              const std::vector<KnownContour>& known) {
  const size_t n = gaps.size();
  const auto gap = [&](size_t i) -> const ContourGap& {
    return known[gaps[i].ring].gaps[gaps[i].gap];
  };
  std::vector<double> bends;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) bends.push_back(bending(gap(i).from, gap(j).to));
  std::vector<size_t> order(n);
  std::iota(order.begin(), order.end(), size_t{0});
  std::optional<std::vector<size_t>> best;
  double least = too_far;
  do {
    double sum = 0;
    for (size_t i = 0; i < n; ++i) sum += bends[i * n + order[i]];
    if (sum >= least || !connects(gaps, order, known.size())) continue;
    least = sum;
    best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

/// Adds the arc of the link and the known contour after it.
void add_link(const GapLink& link, const std::vector<LabelRing>& rings,
              const std::vector<KnownContour>& known, Ring& bridged) {
  const ContourGap& to = known[link.to.ring].gaps[link.to.gap];
  const std::vector<Point2> arc =
      smooth_arc(known[link.from.ring].gaps[link.from.gap].from, to.to, 1.0);
  bridged.insert(bridged.end(), arc.begin(), arc.end());
  const LabelRing& ring = rings[link.to.ring];
  const std::vector<uint8_t>& hidden = known[link.to.ring].hidden;
  for (size_t i = (to.first + to.count) % ring.size(); hidden[i] == 0; i = (i + 1) % ring.size())
    bridged.push_back(ring.sides[i]);
}

/// Links of all gaps: to themselves, or in several pieces so that they are one. Nothing where an
/// arc would turn too far, or there are too many.
std::optional<std::vector<GapLink>> link_gaps(const std::vector<LabelRing>& rings,
                                              const std::vector<KnownContour>& known) {
  std::vector<RingGap> gaps;
  std::vector<RingGap> holes;
  size_t pieces = 0;
  for (size_t r = 0; r < rings.size(); ++r) {
    pieces += rings[r].hole || known[r].gaps.empty() ? 0 : 1;
    for (size_t g = 0; g < known[r].gaps.size(); ++g)
      (rings[r].hole ? holes : gaps).push_back({r, g});
  }
  std::vector<size_t> order(gaps.size() + holes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  if (pieces > 1) {
    if (gaps.size() > most_gaps) return std::nullopt;
    const auto best = least_bent(gaps, known);
    if (!best) return std::nullopt;
    std::copy(best->begin(), best->end(), order.begin());
  }
  gaps.insert(gaps.end(), holes.begin(), holes.end());
  std::vector<GapLink> links;
  for (size_t i = 0; i < gaps.size(); ++i) {
    const RingGap& to = gaps[order[i]];
    const size_t after = (to.gap + 1) % known[to.ring].gaps.size();
    links.push_back({gaps[i], to, order[i] - to.gap + after});
    const ContourGap& here = known[gaps[i].ring].gaps[gaps[i].gap];
    if (bending(here.from, known[to.ring].gaps[to.gap].to) == too_far) return std::nullopt;
  }
  return links;
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

std::optional<Outline> bridge_gaps(const std::vector<LabelRing>& rings,
                                   const std::vector<KnownContour>& known) {
  const auto links = link_gaps(rings, known);
  if (!links) return std::nullopt;
  Outline outline;
  for (size_t r = 0; r < rings.size(); ++r)
    if (known[r].gaps.empty() && !(known[r].nothing && rings[r].hole))
      outline.push_back(rings[r].sides);
  std::vector<uint8_t> passed(links->size(), 0);
  for (size_t first = 0; first < links->size(); ++first) {
    Ring ring;
    for (size_t i = first; passed[i] == 0; i = (*links)[i].next) {
      passed[i] = 1;
      add_link((*links)[i], rings, known, ring);
    }
    if (!ring.empty()) outline.push_back(std::move(ring));
  }
  return outline;
}

}  // namespace relievo::understanding
