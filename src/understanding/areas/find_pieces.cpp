#include "understanding/areas/find_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "kernel/base/cyclic_runs.h"
#include "kernel/base/exact_functions.h"
#include "kernel/geometry/polyline.h"
#include "kernel/image/outlines.h"

namespace relievo::understanding {
namespace {

constexpr double silent_votes = 0.5;  ///< T-junctions without a vote, so that few votes count less
constexpr double hiding_vote = 0.1;   ///< least majority of the votes that one area hides another
constexpr double most_turn = 1.6;     ///< rad, largest turn at either end of a hidden contour
constexpr double outside_worth = 3;   ///< rad^2, bend of a contour that runs outside the figure
constexpr double most_bend = 2;       ///< rad^2, largest bend of a hidden contour
constexpr double widest_gap = 0.4;    ///< largest length of a hidden contour, per figure height
// Weights of the log-odds that two areas are one part (see log_odds), from a logistic regression on
// drawings with known parts (docs/understanding/segmentation.md).
constexpr double two_parts = 6.45;
constexpr double hidden_weight = 4.5;
constexpr double beside_weight = 2.75;
constexpr double gap_weight = 2.6;
constexpr double small_part_weight = 1.2;
constexpr double bend_weight = 1.1;
constexpr double unequal_weight = 0.4;
constexpr double sure_odds = 0.4;         ///< least log-odds of two pieces of one part
constexpr double most_hole_cost = 0.7;    ///< largest weighed sum of bend and gap at a hole
constexpr double most_hole_touch = 0.02;  ///< largest share of its contour along the background

using Pair = std::pair<uint16_t, uint16_t>;

/// The end of an area's contour at an occluder, behind which it may continue.
struct ContourEnd {
  uint16_t area = 0;
  uint16_t along = 0;  ///< label on the other side of the contour
  Point2 at;           ///< px
  Point2 onwards;      ///< unit vector into the occluder
};

/// Measurements of the areas and their rings, by label.
struct Areas {
  std::vector<double> size;  ///< px; 0 where there is none
  std::vector<Box2> box;
  std::vector<double> perimeter;  ///< pixel sides
  std::map<Pair, double> sides;   ///< pixel sides of the first along the second
  std::map<Pair, double> votes;   ///< sum of T-junction confidences that the first hides the second
  /// By occluder, the ends of rings that arrive at it and of rings that leave it.
  std::map<uint16_t, std::array<std::vector<ContourEnd>, 2>> ends;
};

void add_junction(const LabelRing& ring, const Junction& junction, Areas& areas) {
  const auto [at, before, after, in, out] = junction;
  const Point2 last = ring.sides[(at + ring.size() - 1) % ring.size()];
  if (in != Point2{} && after != 0)
    areas.ends[after][0].push_back({ring.label, before, last, (1 / norm(in)) * in});
  if (out != Point2{} && before != 0)
    areas.ends[before][1].push_back({ring.label, after, ring.sides[at], (-1 / norm(out)) * out});
  const double vote = t_junction_confidence(junction);
  if (vote == 0) return;
  areas.votes[{ring.label, before}] += vote;
  areas.votes[{ring.label, after}] += vote;
}

Areas measure(const Image16& labels) {
  const size_t count = size_t{*std::max_element(labels.pixels.begin(), labels.pixels.end())} + 1;
  Areas areas{
      std::vector<double>(count), std::vector<Box2>(count), std::vector<double>(count), {}, {}, {}};
  for (const uint16_t label : labels.pixels) ++areas.size[label];
  areas.size[0] = 0;
  for (const LabelRing& ring : trace_label_rings(labels)) {
    for (const Point2& side : ring.sides) areas.box[ring.label].add(side);
    areas.perimeter[ring.label] += static_cast<double>(ring.size());
    const auto same = [&](size_t i, size_t j) { return ring.beyond[i] == ring.beyond[j]; };
    for_each_run(ring.size(), same, [&](size_t first, size_t sides) {
      areas.sides[{ring.label, ring.beyond[first]}] += static_cast<double>(sides);
    });
    for (const Junction& junction : find_junctions(ring)) add_junction(ring, junction, areas);
  }
  return areas;
}

/// Returns whether the T-junctions of two areas show that the first hides the second.
bool hides(const Areas& areas, uint16_t front, uint16_t behind) {
  const auto votes = [&](const Pair& pair) {
    const auto found = areas.votes.find(pair);
    return found == areas.votes.end() ? 0 : found->second;
  };
  const double pro = votes({front, behind});
  const double con = votes({behind, front});
  return pro - con > hiding_vote * (pro + con + silent_votes);
}

/// Computes the bend of a hidden contour from one end to another, rad^2: the energy of a cubic up
/// to a factor, plus outside_worth times the share of its chord outside the figure. Infinite where
/// the ends do not face each other.
double bend(const Image16& labels, const ContourEnd& from, const ContourEnd& to) {
  const Point2 way = to.at - from.at;
  const double first = turn_between(from.onwards, way);
  const double second = turn_between(way, -1 * to.onwards);
  if (std::max(std::abs(first), std::abs(second)) > most_turn)
    return std::numeric_limits<double>::infinity();
  const int steps = std::max(2, static_cast<int>(norm(way)));
  int outside = 0;
  for (int k = 1; k < steps; ++k) {
    const Point2 p = from.at + (static_cast<double>(k) / steps) * way;
    outside += labels.at(static_cast<int>(p.x), static_cast<int>(p.y)) == 0 ? 1 : 0;
  }
  return bend_energy(first, second) + outside_worth * outside / (steps - 1);
}

/// A hidden contour between two areas.
struct Continuation {
  double bend = std::numeric_limits<double>::infinity();  ///< rad^2
  double gap = 0;                                         ///< length, px
};

/// Finds for each pair of areas that do not touch the hidden contour that bends least.
std::map<Pair, Continuation> find_continuations(const Image16& labels, const Areas& areas) {
  std::map<Pair, Continuation> found;
  for (const auto& [occluder, ends] : areas.ends)
    for (const ContourEnd& from : ends[0])
      for (const ContourEnd& to : ends[1]) {
        const Pair pair = std::minmax(from.area, to.area);
        if (from.area == to.area || areas.sides.count(pair) > 0) continue;
        if (!hides(areas, occluder, from.area) || !hides(areas, occluder, to.area)) continue;
        const double energy = bend(labels, from, to);
        Continuation& best = found[pair];
        if (energy < best.bend) best = {energy, distance(from.at, to.at)};
      }
  return found;
}

/// Computes the share of an area's contour along areas that hide it.
double hidden_share(const Areas& areas, uint16_t area) {
  double sides = 0;
  for (auto run = areas.sides.lower_bound({area, 1});
       run != areas.sides.end() && run->first.first == area; ++run)
    if (hides(areas, run->first.second, area)) sides += run->second;
  return sides / areas.perimeter[area];
}

/// Computes the height that two boxes have in common, per height of the lower one.
double beside(const Box2& a, const Box2& b) {
  const double common = std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y);
  const double lower = std::min(a.max.y - a.min.y, b.max.y - b.min.y);
  return std::max(0.0, common) / std::max(1.0, lower);
}

/// Computes the box around all areas except the background, which may have a label.
Box2 figure_box(const Areas& areas, uint16_t background = 0) {
  Box2 box;
  for (size_t label = 1; label < areas.box.size(); ++label)
    if (label != background && !areas.box[label].empty()) box.add(areas.box[label]);
  return box;
}

/// Returns whether an area touches the picture's border, or the background with more than a little
/// of its contour.
bool is_open_to(const Areas& areas, uint16_t area, uint16_t background) {
  const auto touch = areas.sides.find({area, background});
  return areas.sides.count({area, 0}) > 0 ||
         (touch != areas.sides.end() && touch->second > most_hole_touch * areas.perimeter[area]);
}

/// Computes the log-odds that areas a and b are pieces of one part:
///   w1 hidden + w2 beside - w3 log(smaller / figure) - w4 log(larger / smaller) - w5 bend - w6 gap
///   - w0,
/// with the hidden share of their contours, the common share of their heights, the sizes of the
/// smaller and larger one and of the figure, px, and the hidden contour's bend and length per
/// figure height.
double log_odds(const Areas& areas, const Pair& pair, double bend, double gap, double figure) {
  const auto [smaller, larger] = std::minmax(areas.size.at(pair.first), areas.size.at(pair.second));
  const double hidden = std::min(hidden_share(areas, pair.first), hidden_share(areas, pair.second));
  return hidden_weight * hidden +
         beside_weight * beside(areas.box.at(pair.first), areas.box.at(pair.second)) -
         small_part_weight * exact::log(smaller / figure) -
         unequal_weight * exact::log(larger / smaller) - bend_weight * bend - gap_weight * gap -
         two_parts;
}

}  // namespace

std::vector<std::pair<uint16_t, uint16_t>> find_pieces(const Image16& labels) {
  const Areas areas = measure(labels);
  const Box2 box = figure_box(areas);
  const double figure = std::accumulate(areas.size.begin(), areas.size.end(), 0.0);
  std::vector<std::pair<double, Pair>> likely;
  for (const auto& [pair, continuation] : find_continuations(labels, areas)) {
    const double gap = continuation.gap / (box.max.y - box.min.y);
    if (continuation.bend > most_bend || gap > widest_gap) continue;
    const double odds = log_odds(areas, pair, continuation.bend, gap, figure);
    if (odds > sure_odds) likely.emplace_back(-odds, pair);
  }
  std::sort(likely.begin(), likely.end());
  std::vector<Pair> pieces;
  for (const auto& [odds, pair] : likely) pieces.push_back(pair);
  return pieces;
}

std::vector<HoleCue> find_holes(const Image16& labels) {
  // The background gets a label, since its contours count too; 0 is outside the picture then.
  const auto background =
      static_cast<uint16_t>(*std::max_element(labels.pixels.begin(), labels.pixels.end()) + 1);
  Image16 all = labels;
  std::replace(all.pixels.begin(), all.pixels.end(), uint16_t{0}, background);
  const Areas areas = measure(all);
  const Box2 box = figure_box(areas, background);
  const double extent = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const auto is_part = [background](uint16_t label) { return label != 0 && label != background; };
  std::vector<HoleCue> cues;
  for (const auto& [occluder, ends] : areas.ends)
    for (const ContourEnd& from : ends[0])
      for (const ContourEnd& to : ends[1]) {
        const uint16_t area = std::min(from.area, to.area);
        const bool one_is_background =
            area != background && std::max(from.area, to.area) == background;
        const bool in_figure = is_part(from.along) && is_part(to.along) && is_part(occluder);
        if (!one_is_background || !in_figure || is_open_to(areas, area, background)) continue;
        const double cost =
            bend_weight * bend(all, from, to) + gap_weight * distance(from.at, to.at) / extent;
        if (cost < most_hole_cost) cues.push_back({area, from.along, to.along});
      }
  return cues;
}

}  // namespace relievo::understanding
