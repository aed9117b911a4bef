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

constexpr size_t noise_sides = 4;  ///< shorter runs of hidden or known sides are noise
/// The stretch of contour beside a gap that gives the direction there: a share of the ring's sides,
/// within bounds.
constexpr double window_share = 0.08;
constexpr size_t min_window = 8;
constexpr size_t max_window = 40;
/// A straight line is fitted in place of a parabola to fewer points.
constexpr size_t parabola_points = 12;
constexpr double max_turn = 1.35 * std::numbers::pi;  ///< of an arc across a gap: 243 degrees
constexpr double too_far = std::numeric_limits<double>::infinity();
constexpr size_t most_gaps = 6;  ///< of a part in several pieces; all their permutations are tried

/// Maximal runs of `value`, without ends; none where the whole circle has one value.
std::vector<ContourGap> runs_of(const std::vector<uint8_t>& circle, uint8_t value) {
  std::vector<ContourGap> runs;
  const size_t n = circle.size();
  const auto same = [&](size_t i, size_t j) { return circle[i] == circle[j]; };
  for_each_run(n, same, [&](size_t first, size_t count) {
    if (circle[first] == value && count < n) runs.push_back({first, count, {}, {}});
  });
  return runs;
}

void drop_short_runs(std::vector<uint8_t>& circle, uint8_t value) {
  for (const ContourGap& run : runs_of(circle, value))
    if (run.count < noise_sides)
      for (size_t i = 0; i < run.count; ++i)
        circle[(run.first + i) % circle.size()] = static_cast<uint8_t>(1 - value);
}

/// The start and direction of the parabola that fits the points best in the least-squares sense.
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

/// Fits the ends of a gap to the known runs before and after it, of these lengths.
void find_ends(const LabelRing& ring, size_t before, size_t after, ContourGap& gap) {
  const size_t n = ring.size();
  const auto share = static_cast<size_t>(window_share * static_cast<double>(n));
  const size_t window = std::clamp(share, min_window, max_window);
  // The direction from the gap along a known run, which begins at side `begin`.
  const auto fit = [&](size_t begin, size_t known, bool backwards) {
    const size_t skipped = std::min(junction_sides, (known - 2) / 2);
    std::vector<Point2> points;
    for (size_t i = skipped; i < std::min(window + skipped, known); ++i)
      points.push_back(ring.sides[(backwards ? begin + 2 * n - i : begin + i) % n]);
    return fit_end(points);
  };
  gap.from = fit(gap.first + n - 1, before, true);
  gap.from.direction = -1.0 * gap.from.direction;
  gap.to = fit(gap.first + gap.count, after, false);
}

/// A gap among those of all rings.
struct RingGap {
  size_t ring = 0;
  size_t gap = 0;
};

double bending(const DirectedPoint& from, const DirectedPoint& to) {
  if (std::abs(turning(from, to)) > max_turn) return too_far;
  const Point2 chord = to.at - from.at;
  return bend_energy(turn_between(from.direction, chord), turn_between(chord, to.direction));
}

/// Appends the arc from one gap to another and the known contour of `ring`, the second one's, after
/// it.
void append_arc(const ContourGap& from, const ContourGap& to, const LabelRing& ring,
                const std::vector<uint8_t>& hidden, Ring& bridged) {
  const std::vector<Point2> arc = smooth_arc(from.from, to.to, 1.0);
  bridged.insert(bridged.end(), arc.begin(), arc.end());
  for (size_t i = (to.first + to.count) % ring.size(); hidden[i] == 0; i = (i + 1) % ring.size())
    bridged.push_back(ring.sides[i]);
}

/// Whether contours that continue from every gap at the one in that order connect all rings.
bool connects(const std::vector<RingGap>& gaps, const std::vector<size_t>& order, size_t rings) {
  DisjointSets pieces(static_cast<int>(rings));
  for (size_t i = 0; i < gaps.size(); ++i)
    pieces.unite(static_cast<int>(gaps[i].ring), static_cast<int>(gaps[order[i]].ring));
  const int first = pieces.find(static_cast<int>(gaps[0].ring));
  return std::all_of(gaps.begin(), gaps.end(), [&](const RingGap& gap) {
    return pieces.find(static_cast<int>(gap.ring)) == first;
  });
}

/// Per gap, the gap at which the contour continues, so that all pieces are connected and the arcs
/// bend least. Nothing where every way turns too far. O(gaps!).
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

/// All gaps, those of outer rings first. The gaps of a ring are consecutive.
std::vector<RingGap> list_gaps(const std::vector<LabelRing>& rings,
                               const std::vector<KnownContour>& known) {
  std::vector<RingGap> gaps;
  for (const bool hole : {false, true})
    for (size_t r = 0; r < rings.size(); ++r)
      for (size_t g = 0; rings[r].hole == hole && g < known[r].gaps.size(); ++g)
        gaps.push_back({r, g});
  return gaps;
}

/// Per gap, the gap at which the contour continues: itself, or in a part of several pieces another
/// that connects them. Nothing where an arc would turn too far, or there are too many gaps.
std::optional<std::vector<size_t>> link_gaps(const std::vector<LabelRing>& rings,
                                             const std::vector<KnownContour>& known,
                                             const std::vector<RingGap>& gaps) {
  std::vector<RingGap> outer;
  size_t pieces = 0;
  for (const RingGap& gap : gaps) {
    if (rings[gap.ring].hole) continue;
    pieces += gap.gap == 0 ? 1 : 0;
    outer.push_back(gap);
  }
  std::vector<size_t> order(gaps.size());
  std::iota(order.begin(), order.end(), size_t{0});
  if (pieces > 1) {
    if (outer.size() > most_gaps) return std::nullopt;
    const auto best = least_bent(outer, known);
    if (!best) return std::nullopt;
    std::copy(best->begin(), best->end(), order.begin());
  }
  for (size_t i = 0; i < gaps.size(); ++i) {
    const ContourGap& from = known[gaps[i].ring].gaps[gaps[i].gap];
    const RingGap& to = gaps[order[i]];
    if (bending(from.from, known[to.ring].gaps[to.gap].to) == too_far) return std::nullopt;
  }
  return order;
}

}  // namespace

KnownContour find_gaps(const LabelRing& ring, std::vector<uint8_t> may_be_hidden) {
  KnownContour known;
  drop_short_runs(may_be_hidden, 1);
  drop_short_runs(may_be_hidden, 0);
  known.gaps = runs_of(may_be_hidden, 1);
  known.nothing = known.gaps.empty() && !may_be_hidden.empty() && may_be_hidden[0] == 1;
  const size_t n = ring.size();
  for (size_t k = 0; k < known.gaps.size(); ++k) {
    ContourGap& gap = known.gaps[k];
    const ContourGap& previous = known.gaps[(k + known.gaps.size() - 1) % known.gaps.size()];
    const ContourGap& next = known.gaps[(k + 1) % known.gaps.size()];
    // With a single gap the known run before it and after it are the same.
    const size_t before = (gap.first + 2 * n - previous.first - previous.count) % n;
    const size_t after = (next.first + 2 * n - gap.first - gap.count) % n;
    find_ends(ring, before == 0 ? n - gap.count : before, after == 0 ? n - gap.count : after, gap);
  }
  known.hidden = std::move(may_be_hidden);
  return known;
}

std::optional<Outline> bridge_gaps(const std::vector<LabelRing>& rings,
                                   const std::vector<KnownContour>& known) {
  const std::vector<RingGap> gaps = list_gaps(rings, known);
  const auto order = link_gaps(rings, known, gaps);
  if (!order) return std::nullopt;
  Outline outline;
  for (size_t r = 0; r < rings.size(); ++r)
    if (known[r].gaps.empty() && !(known[r].nothing && rings[r].hole))
      outline.push_back(rings[r].sides);
  std::vector<uint8_t> passed(gaps.size(), 0);
  for (size_t first = 0; first < gaps.size(); ++first) {
    Ring bridged;
    for (size_t i = first; passed[i] == 0;) {
      passed[i] = 1;
      const RingGap& from = gaps[i];
      const RingGap& to = gaps[(*order)[i]];
      append_arc(known[from.ring].gaps[from.gap], known[to.ring].gaps[to.gap], rings[to.ring],
                 known[to.ring].hidden, bridged);
      i = (*order)[i] - to.gap + (to.gap + 1) % known[to.ring].gaps.size();
    }
    if (!bridged.empty()) outline.push_back(std::move(bridged));
  }
  return outline;
}

}  // namespace relievo::understanding
