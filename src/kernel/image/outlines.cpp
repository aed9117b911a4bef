#include "kernel/image/outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <vector>

#include "kernel/base/exact_functions.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/geometry/polyline.h"

namespace relievo {
namespace {

Image16 as_labels(const Mask& mask) {
  Image16 labels(mask.inside.width, mask.inside.height, 1);
  std::copy(mask.inside.pixels.begin(), mask.inside.pixels.end(), labels.pixels.begin());
  return labels;
}

/// Simplifies a ring in thirds, so that no piece is closed.
Ring simplified(const Ring& ring, double tolerance) {
  if (ring.size() < 8) return ring;
  const auto third = static_cast<std::ptrdiff_t>(ring.size() / 3);
  const auto last = static_cast<std::ptrdiff_t>(ring.size() - 1);
  const std::array<std::ptrdiff_t, 4> ends = {0, third, 2 * third, last};
  Ring few;
  for (size_t k = 0; k < 3; ++k) {
    const Ring piece =
        simplify_line({ring.begin() + ends[k], ring.begin() + ends[k + 1] + 1}, tolerance);
    few.insert(few.end(), piece.begin(), piece.end() - 1);
  }
  few.push_back(ring.back());
  return few;
}

/// Entries of D'D, where D takes the third differences of a closed ring, by distance from the
/// diagonal.
constexpr std::array<double, 4> jerk_stencil = {20, -15, 6, -1};
constexpr double most_of_width = 0.125;  ///< largest move of an outline over the mask's mean width
constexpr int least_fair = 8;            ///< points; shorter rings stay as they are
constexpr int most_rounds = 12;
constexpr double least_growth = 1.5;  ///< of a weight in a round

/// Returns the lower triangle of stiffness D'D on n points, n > 6.
SparseMatrix jerk_matrix(int n, double stiffness) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < static_cast<int>(jerk_stencil.size()); ++k) {
      const int j = (i + k) % n;
      entries.emplace_back(std::max(i, j), std::min(i, j), stiffness * jerk_stencil[k]);
    }
  SparseMatrix J(n, n);
  J.setFromTriplets(entries.begin(), entries.end());
  return J;
}

/// Returns an elimination order of a ring, from both sides in turn, with the fill-in of a chain.
std::vector<int> order_of_ring(int n) {
  std::vector<int> order;
  for (int i = 0; 2 * i < n; ++i) {
    order.push_back(i);
    if (n - 1 - i > i) order.push_back(n - 1 - i);
  }
  return order;
}

/// Moves a coordinate towards `to` by at most `reach`.
double moved(double from, double to, double reach) {
  return std::clamp(to, from - reach, from + reach);
}

/// Computes the fair curve x near a ring p of equally spaced points, which minimises
///   sum w |x - p|^2 + stiffness |D x|^2,   stiffness = (wavelength / 2 pi)^6.
/// It halves the amplitude of waves of that length, in points, which is at most a third of the
/// ring, so that circles stay round. The weights w are 1 at first. Where x is farther than `reach`
/// from p in x or y they grow, for a few rounds, so that corners stay. O(n) a round.
Ring fair(const Ring& ring, double wavelength, double reach) {
  const int n = static_cast<int>(ring.size());
  if (n < least_fair || wavelength <= 0) return ring;
  const double length = std::min(wavelength, n / 3.0) / (2 * std::numbers::pi);
  const double cube = length * length * length;
  const SparseMatrix J = jerk_matrix(n, cube * cube);
  SparseCholesky factor;
  factor.analyse(J, Refactorisation::complete, order_of_ring(n));
  Ring curve = ring;
  std::vector<double> weight(n, 1);
  for (int round = 0; round < most_rounds; ++round) {
    SparseMatrix K = J;
    Eigen::VectorXd x(n);
    Eigen::VectorXd y(n);
    for (int i = 0; i < n; ++i) {
      K.valuePtr()[K.outerIndexPtr()[i]] += weight[i];  // the diagonal comes first in its column
      x[i] = weight[i] * ring[i].x;
      y[i] = weight[i] * ring[i].y;
    }
    if (!factor.factorise(K)) break;
    x = factor.solve(x);
    y = factor.solve(y);
    bool within = true;
    for (int i = 0; i < n; ++i) {
      curve[i] = {moved(ring[i].x, x[i], reach), moved(ring[i].y, y[i], reach)};
      const double off = std::max(std::abs(x[i] - ring[i].x), std::abs(y[i] - ring[i].y)) / reach;
      if (off <= 1) continue;
      weight[i] *= least_growth * off * off;
      within = false;
    }
    if (within) break;
  }
  return curve;
}

/// A side of a pixel: 0 top, 1 right, 2 bottom, 3 left, travelled clockwise.
struct Side {
  int x = 0;
  int y = 0;
  int side = 0;
  friend bool operator==(const Side&, const Side&) = default;
};

constexpr std::array<int, 4> normal_x = {0, 1, 0, -1};
constexpr std::array<int, 4> normal_y = {-1, 0, 1, 0};

/// Follows the boundaries of all labels.
class RingTracer {
 public:
  explicit RingTracer(const Image16& labels)
      : labels_(labels), visited_(labels.width, labels.height, 1) {}

  std::vector<LabelRing> trace() {
    std::vector<LabelRing> rings;
    for (int y = 0; y < labels_.height; ++y)
      for (int x = 0; x < labels_.width; ++x) {
        if (is_inside(x, y)) continue;
        for (int side = 0; side < 4; ++side)
          if (starts_ring({x, y, side})) rings.push_back(ring({x, y, side}));
      }
    return rings;
  }

 private:
  uint16_t label(int x, int y) const {
    const bool inside = x >= 0 && y >= 0 && x < labels_.width && y < labels_.height;
    return inside ? labels_.at(x, y) : uint16_t{0};
  }
  uint16_t beyond(const Side& s) const {
    return label(s.x + normal_x[s.side], s.y + normal_y[s.side]);
  }
  /// Returns whether no ring runs along the pixel.
  bool is_inside(int x, int y) const {
    const uint16_t* p = &labels_.at(x, y);
    if (*p == 0) return true;
    if (x == 0 || y == 0 || x + 1 == labels_.width || y + 1 == labels_.height) return false;
    const int w = labels_.width;
    return p[-1] == *p && p[1] == *p && p[-w] == *p && p[w] == *p;
  }
  bool starts_ring(const Side& s) const {
    const uint16_t own = labels_.at(s.x, s.y);
    return own != 0 && beyond(s) != own && (visited_.at(s.x, s.y) & (1U << s.side)) == 0;
  }

  /// Returns the side that follows: around the corner of the same pixel, straight on, or inwards.
  Side next(const Side& s) const {
    const int turn = (s.side + 1) % 4;
    const uint16_t own = labels_.at(s.x, s.y);
    const int ahead_x = s.x + normal_x[turn];
    const int ahead_y = s.y + normal_y[turn];
    if (label(ahead_x, ahead_y) != own) return {s.x, s.y, turn};
    const int across_x = ahead_x + normal_x[s.side];
    const int across_y = ahead_y + normal_y[s.side];
    if (label(across_x, across_y) != own) return {ahead_x, ahead_y, s.side};
    return {across_x, across_y, (s.side + 3) % 4};
  }

  LabelRing ring(const Side& start) {
    LabelRing ring;
    ring.label = labels_.at(start.x, start.y);
    Side s = start;
    double area = 0;
    do {
      visited_.at(s.x, s.y) = static_cast<uint8_t>(visited_.at(s.x, s.y) | (1U << s.side));
      ring.sides.push_back(
          {s.x + 0.5 + 0.5 * normal_x[s.side], s.y + 0.5 + 0.5 * normal_y[s.side]});
      ring.beyond.push_back(beyond(s));
      // The divergence theorem on vertical sides, which are one unit long.
      area += normal_x[s.side] * ring.sides.back().x;
      s = next(s);
    } while (!(s == start));
    ring.hole = area < 0;
    return ring;
  }

  const Image16& labels_;
  Image8 visited_;  ///< per pixel, one bit a side
};

constexpr size_t near_side = 3;  ///< pixel sides at a junction that do not count for its directions
constexpr size_t far_side = 14;  ///< pixel sides from a junction up to which they count
constexpr double spread = std::numbers::pi / 6;  ///< s below, from Palou and Salembier

/// Counts the sides from `at` on, in steps of 1 or n - 1, with the same label beyond, up to
/// far_side.
size_t run_length(const LabelRing& ring, size_t at, size_t step) {
  size_t count = 0;
  for (size_t i = at; count < far_side && ring.beyond[i] == ring.beyond[at];
       i = (i + step) % ring.size())
    ++count;
  return count;
}

}  // namespace

Outline outline_of(const Mask& mask, const OutlineOptions& options) {
  const std::vector<LabelRing> rings = trace_label_rings(as_labels(mask));
  size_t longest = 0;
  size_t sides = 0;
  for (const LabelRing& ring : rings) {
    longest = std::max(longest, ring.size());
    sides += ring.size();
  }
  const size_t least = std::min(static_cast<size_t>(options.min_sides), longest);
  if (sides == 0) return {};
  const double width = 2 * static_cast<double>(pixel_count(mask)) / static_cast<double>(sides);
  const double reach = std::min(options.reach, most_of_width * width);
  const double wavelength = options.wavelength * reach / options.reach;
  const Point2 offset{static_cast<double>(mask.left), static_cast<double>(mask.top)};
  Outline outline;
  for (const LabelRing& traced : rings) {
    if (traced.size() < least) continue;
    Ring ring = traced.sides;
    for (Point2& p : ring) p = p + offset;
    outline.push_back(simplified(fair(ring, wavelength, reach), options.tolerance));
  }
  return outline;
}

Box2 box_of(const Image8& mask) {
  Box2 box;
  for (int y = 0; y < mask.height; ++y) {
    const auto begin = mask.pixels.begin() + static_cast<std::ptrdiff_t>(y) * mask.width;
    const auto end = begin + mask.width;
    const auto is_inside = [](uint8_t value) { return value != 0; };
    const auto first = std::find_if(begin, end, is_inside);
    if (first == end) continue;
    const auto last =
        std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), is_inside);
    box.add(Point2{static_cast<double>(first - begin), y * 1.0});
    box.add(Point2{static_cast<double>(last.base() - begin), y + 1.0});
  }
  return box;
}

Mask fill_outline(const Outline& outline, int width, int height) {
  const Box2 box = bounding_box(outline);
  if (box.empty()) return {};
  const int left = first_centre(box.min.x, width);
  const int top = first_centre(box.min.y, height);
  const int right = first_centre(box.max.x, width);
  const int bottom = first_centre(box.max.y, height);
  if (right <= left || bottom <= top) return {};
  Mask mask = empty_mask(left, top, right, bottom);
  const CellGrid grid{{left * 1.0, top * 1.0}, 1, right - left, bottom - top};
  for (const CellRun& run : cells_inside(outline, grid))
    for (int x = run.begin; x < run.end; ++x) mask.inside.at(x, run.row) = 1;
  return mask;
}

std::vector<LabelRing> trace_label_rings(const Image16& labels) {
  return RingTracer(labels).trace();
}

std::vector<Junction> find_junctions(const LabelRing& ring) {
  std::vector<Junction> junctions;
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    const size_t previous = (i + n - 1) % n;
    if (ring.beyond[i] == ring.beyond[previous]) continue;
    Junction junction{i, ring.beyond[previous], ring.beyond[i], {}, {}};
    const size_t before = run_length(ring, previous, n - 1);
    const size_t after = run_length(ring, i, 1);
    if (before > near_side + 1)
      junction.in = ring.sides[(i + n - near_side) % n] - ring.sides[(i + n - before) % n];
    if (after > near_side + 1)
      junction.out = ring.sides[(i + after - 1) % n] - ring.sides[(i + near_side) % n];
    junctions.push_back(junction);
  }
  return junctions;
}

/// confidence = exp(-|turn| / s^2): G. Palou, P. Salembier, Monocular depth ordering using
/// T-junctions and convexity occlusion cues (2013).
double t_junction_confidence(const Junction& junction) {
  if (junction.in == Point2{} || junction.out == Point2{}) return 0;
  return exact::exp(-std::abs(turn_between(junction.in, junction.out)) / (spread * spread));
}

}  // namespace relievo
