#include "understanding/areas/find_neck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/geometry/polyline.h"
#include "kernel/image/components.h"
#include "kernel/image/distance_transform.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"

namespace relievo::understanding {
namespace {

constexpr double contour_step = 1.5;  ///< cells between points of a contour
/// Removes the staircase of the cells alone.
constexpr OutlineOptions contour_options{.wavelength = 12, .reach = 0.5};
constexpr int turn_reach = 4;         ///< contour points to either side that make up a turn
constexpr double concave_turn = 0.6;  ///< rad, least turn of a concave point
constexpr int contour_look = 4;       ///< cells beyond the contour that are searched for a region
// Lengths below are per length of the neck.
constexpr double limb_length = 1.3;   ///< least distance from the neck to a limb's end
constexpr double head_radius = 0.8;   ///< least radius of a round limb's largest disc
constexpr double body_radius = 0.85;  ///< least radius of the rest's largest disc beside the neck
constexpr double body_reach = 1.5;    ///< largest distance from the neck to that disc's centre
constexpr double free_share = 0.6;    ///< least share of a limb's contour along the background
/// Least share of the rest's contour along the background; with less it is a limb of another part.
constexpr double body_share = 0.3;
constexpr double least_whole = 2;      ///< least area of the whole region, per limb
constexpr double widest_neck = 1.2;    ///< largest length of a neck, per square root of limb area
constexpr double both_concave = 0.75;  ///< factor to the cost of a neck between two concave points

/// The area beyond a contour.
enum class Beyond : uint8_t { background, itself, other };

struct ContourPoint {
  Point2 at;  ///< cells
  Beyond beyond = Beyond::background;
  bool concave = false;
};

using Contour = std::vector<ContourPoint>;

/// A chord between two points of a contour. The limb's contour runs from `from` to `to`.
struct Chord {
  size_t from = 0;
  size_t to = 0;
  double length = 0;  ///< cells
  double cost = std::numeric_limits<double>::infinity();
};

/// Computes the box of a region's cells between its lines, with a margin of one; an empty mask.
Mask box_of_cells(const NeckGrid& grid, int region) {
  int left = grid.region.width;
  int top = grid.region.height;
  int right = 0;
  int bottom = 0;
  for (int y = 0; y < grid.region.height; ++y)
    for (int x = 0; x < grid.region.width; ++x) {
      if (grid.region.at(x, y) != region || grid.wall.at(x, y) != 0) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = y + 1;
    }
  if (right == 0) return {};
  return empty_mask(left - 1, top - 1, right + 1, bottom + 1);
}

/// Fills the mask, which is their box, with the cells of a region between its lines and with its
/// holes, except those that contain background.
Mask cells_of(const NeckGrid& grid, int region, Mask cells) {
  Image8 other(cells.inside.width, cells.inside.height, 1);
  const auto has = [&](int x, int y) { return grid.has(cells.left + x, cells.top + y); };
  const auto region_at = [&](int x, int y) {
    return grid.region.at(cells.left + x, cells.top + y);
  };
  for (int y = 0; y < other.height; ++y)
    for (int x = 0; x < other.width; ++x)
      other.at(x, y) = !has(x, y) || region_at(x, y) != region ||
                       grid.wall.at(cells.left + x, cells.top + y) != 0;
  const Components holes = connected_components(other, Connectivity::corners);
  // The margin is connected to what lies around the box.
  std::vector<uint8_t> open = pieces_at_edge(holes);
  for (int y = 0; y < other.height; ++y)
    for (int x = 0; x < other.width; ++x)
      if (has(x, y) && region_at(x, y) == 0) open[holes.label.at(x, y)] = 1;
  for (size_t i = 0; i < other.pixels.size(); ++i) {
    const int32_t hole = holes.label.pixels[i];
    cells.inside.pixels[i] = hole == 0 || open[hole] == 0 ? 1 : 0;
  }
  return cells;
}

/// Returns the area beyond the line at a point of the contour, in a direction out of the region.
Beyond look_beyond(const NeckGrid& grid, int region, Point2 p, Point2 outwards) {
  for (int step = 1; step <= contour_look; ++step) {
    const int x = static_cast<int>(std::floor(p.x + step * outwards.x));
    const int y = static_cast<int>(std::floor(p.y + step * outwards.y));
    if (!grid.has(x, y) || grid.region.at(x, y) == 0) return Beyond::background;
    if (grid.wall.at(x, y) != 0) continue;
    if (grid.region.at(x, y) != region) return Beyond::other;
    if (step > 1) return Beyond::itself;
  }
  return Beyond::itself;
}

/// Computes the turn of a contour at point k, rad; negative where it is concave.
double turn_at(const std::vector<Point2>& ring, size_t k) {
  const size_t n = ring.size();
  const Point2 in = ring[k] - ring[(k + n - turn_reach) % n];
  const Point2 out = ring[(k + turn_reach) % n] - ring[k];
  return turn_between(in, out);
}

/// Traces the outer contour of the largest piece, clockwise on the screen. Empty where it is short.
Contour contour_of(const NeckGrid& grid, int region, const Mask& cells) {
  Contour contour;
  Ring outer;
  for (const Ring& ring : outline_of(cells, contour_options))
    if (outer.empty() || signed_area(ring) > signed_area(outer)) outer = ring;
  const RingMeasure along = measure(outer);
  const auto count = static_cast<size_t>(along.length / contour_step);
  if (count < 4 * turn_reach) return contour;
  std::vector<Point2> ring;
  for (size_t k = 0; k < count; ++k)
    ring.push_back(
        point_at(outer, along, along.length * static_cast<double>(k) / static_cast<double>(count)));
  for (size_t k = 0; k < count; ++k) {
    const Point2 way = ring[(k + 1) % count] - ring[(k + count - 1) % count];
    const double length = std::max(1e-9, norm(way));
    const Point2 outwards{way.y / length, -way.x / length};
    contour.push_back(
        {ring[k], look_beyond(grid, region, ring[k], outwards), turn_at(ring, k) < -concave_turn});
  }
  return contour;
}

/// Finds the best neck of one region.
class NeckFinder {
 public:
  NeckFinder(const NeckGrid& grid, int region, Mask cells, double least_area)
      : cells_(std::move(cells)),
        contour_(contour_of(grid, region, cells_)),
        least_area_(least_area) {
    squared_ = squared_distance_to(complement(cells_.inside));
    for (size_t k = 0; k < contour_.size(); ++k) {
      const Point2 p = contour_[k].at;
      const Point2 q = contour_[(k + 1) % contour_.size()].at;
      twice_area_.push_back((twice_area_.empty() ? 0 : twice_area_.back()) + cross(p, q));
      free_.push_back((free_.empty() ? 0 : free_.back()) +
                      (contour_[k].beyond == Beyond::background ? 1 : 0));
    }
  }

  /// Returns the neck that is narrowest compared with its limb.
  std::optional<Neck> find() const {
    Chord best;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < contour_.size(); ++i) {
      if (!contour_[i].concave || contour_[i].beyond == Beyond::other) continue;
      const Chord chord = nearest_from(i);
      if (chord.length == 0) continue;
      const double narrow = chord.cost / std::sqrt(limb_area(chord));
      if (narrow >= least) continue;
      least = narrow;
      best = chord;
    }
    if (best.length == 0) return std::nullopt;
    return neck_of(best);
  }

 private:
  Neck neck_of(const Chord& chord) const {
    Neck neck{{}, {}, is_round(chord)};
    for (size_t k = 0; k <= count_of(chord); ++k)
      neck.limb.push_back(contour_[(chord.from + k) % contour_.size()].at);
    for (const ContourPoint& point : contour_) neck.whole.push_back(point.at);
    return neck;
  }

  /// Returns the cheapest neck that begins or ends at a point; its length is 0 where there is none.
  Chord nearest_from(size_t i) const {
    std::vector<Chord> chords;
    for (size_t j = 0; j < contour_.size(); ++j) {
      if (i == j || contour_[j].beyond == Beyond::other) continue;
      const double length = distance(contour_[i].at, contour_[j].at);
      const double cost = length * (contour_[j].concave ? both_concave : 1);
      for (const Chord chord : {Chord{i, j, length, cost}, Chord{j, i, length, cost}})
        if (is_limb(chord)) chords.push_back(chord);
    }
    std::sort(chords.begin(), chords.end(),
              [](const Chord& a, const Chord& b) { return a.cost < b.cost; });
    for (const Chord& chord : chords)
      if (is_neck(chord)) return chord;
    return {};
  }

  /// Counts the points of the limb's contour, without the last.
  size_t count_of(const Chord& chord) const {
    return (chord.to + contour_.size() - chord.from) % contour_.size();
  }

  /// Computes the area between the limb's contour and the chord.
  double limb_area(const Chord& chord) const {
    const auto before = [&](size_t k) { return k == 0 ? 0 : twice_area_[k - 1]; };
    const double all = twice_area_.back();
    double sum = before(chord.to) - before(chord.from);
    if (chord.to < chord.from) sum += all;
    return (sum + cross(contour_[chord.to].at, contour_[chord.from].at)) / 2;
  }

  /// Computes the share of the limb's contour along the background.
  double free_of(const Chord& chord) const {
    const auto before = [&](size_t k) { return k == 0 ? 0 : free_[k - 1]; };
    const int sum =
        before(chord.to) - before(chord.from) + (chord.to < chord.from ? free_.back() : 0);
    return static_cast<double>(sum) / static_cast<double>(std::max<size_t>(1, count_of(chord)));
  }

  /// Returns the distance from a point to the nearest cell outside, cells; 0 outside.
  double distance_at(Point2 p) const {
    const int x = static_cast<int>(std::floor(p.x)) - cells_.left;
    const int y = static_cast<int>(std::floor(p.y)) - cells_.top;
    if (x < 0 || y < 0 || x >= squared_.width || y >= squared_.height) return 0;
    return std::sqrt(static_cast<double>(squared_.at(x, y)));
  }

  bool runs_inside(const Chord& chord) const {
    const Point2 a = contour_[chord.from].at;
    const Point2 b = contour_[chord.to].at;
    for (double s = 1.5; s < chord.length - 1.5; s += 0.75)
      if (distance_at(a + (s / chord.length) * (b - a)) == 0) return false;
    return true;
  }

  /// Computes the radius of the largest disc whose centre lies on one side of the chord, the limb's
  /// or the other, up to `reach` from its middle.
  double disc_beside(const Chord& chord, bool limb, double reach) const {
    const Point2 a = contour_[chord.from].at;
    const Point2 b = contour_[chord.to].at;
    const Point2 middle = 0.5 * (a + b);
    double largest = 0;
    const double step = std::max(1.0, reach / 8);
    for (double dy = -reach; dy <= reach; dy += step)
      for (double dx = -reach; dx <= reach; dx += step) {
        const Point2 p = middle + Point2{dx, dy};
        if (dx * dx + dy * dy > reach * reach || (cross(b - a, p - a) < 0) != limb) continue;
        largest = std::max(largest, distance_at(p));
      }
    return largest;
  }

  double length_of_limb(const Chord& chord) const {
    const Point2 middle = 0.5 * (contour_[chord.from].at + contour_[chord.to].at);
    double longest = 0;
    for (size_t k = 0; k < count_of(chord); ++k)
      longest =
          std::max(longest, distance(middle, contour_[(chord.from + k) % contour_.size()].at));
    return longest;
  }

  bool is_round(const Chord& chord) const {
    return disc_beside(chord, true, chord.length * body_reach) >= head_radius * chord.length;
  }

  /// Returns whether the area that a chord cuts off is large enough and borders on the background.
  bool is_limb(const Chord& chord) const {
    const double area = limb_area(chord);
    return area >= least_area_ && 2 * least_whole * area <= twice_area_.back() &&
           chord.length < widest_neck * std::sqrt(area) && free_of(chord) >= free_share &&
           free_of({chord.to, chord.from}) >= body_share;
  }

  bool is_neck(const Chord& chord) const {
    return runs_inside(chord) &&
           disc_beside(chord, false, body_reach * chord.length) >= body_radius * chord.length &&
           (length_of_limb(chord) >= limb_length * chord.length || is_round(chord));
  }

  Mask cells_;
  Contour contour_;
  double least_area_;               ///< cells
  Image<int32_t> squared_;          ///< squared distances to the outside, cells^2
  std::vector<double> twice_area_;  ///< [points] cumulated, up to and with each side
  std::vector<int> free_;           ///< [points] cumulated number along the background
};

}  // namespace

std::optional<Neck> find_neck(const NeckGrid& grid, int region, double least_area) {
  Mask box = box_of_cells(grid, region);
  const double most_area = static_cast<double>(box.inside.pixels.size());
  if (most_area <= least_whole * least_area) return std::nullopt;
  return NeckFinder(grid, region, cells_of(grid, region, std::move(box)), least_area).find();
}

}  // namespace relievo::understanding
