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
#include "kernel/image/ring_changes.h"

namespace relievo::understanding {
namespace {

/// Pixel sides beside a junction that tell where a contour goes, and how many next to it do not.
constexpr size_t far_beside = 14;
constexpr size_t near_beside = 3;
constexpr double straight_turn = 0.27;  ///< rad, by which a contour that turns counts 1 / e
constexpr double silent_votes = 0.5;    ///< of junctions, beside which those that vote are weighed
constexpr double hiding_vote = 0.1;     ///< of junctions for what hides another, at least
constexpr double most_turn = 1.6;       ///< rad, at either end of a hidden contour
constexpr double outside_worth = 3;     ///< rad^2, of one that runs outside the figure
constexpr double most_bend = 2;         ///< rad^2
constexpr double widest_gap = 0.4;      ///< of the figure's height
/// Log-odds of two such areas to be one part, fitted by logistic regression, and from which on they
/// are taken for one (docs/understanding/segmentation.md).
constexpr double two_parts = 6.45;
constexpr double hidden_weight = 4.5;
constexpr double beside_weight = 2.75;
constexpr double gap_weight = 2.6;
constexpr double small_part_weight = 1.2;
constexpr double bend_weight = 1.1;
constexpr double unequal_weight = 0.4;
constexpr double sure_odds = 0.4;
constexpr double most_hole_cost = 0.7;    ///< of bend and gap, by the weights above
constexpr double most_hole_touch = 0.02;  ///< of a hole's contour that lies on the background

using Pair = std::pair<uint16_t, uint16_t>;

/// Where the contour of an area ends at what hides the rest of it.
struct ContourEnd {
  uint16_t area = 0;
  uint16_t along = 0;  ///< what lies on its other side
  Point2 at;
  Point2 onwards;  ///< unit, into what hides it
};

/// What the rings of areas tell; all by label.
struct Areas {
  std::vector<double> size;  ///< px; 0 where there is none
  std::vector<Box2> box;
  std::vector<double> perimeter;  ///< pixel sides
  std::map<Pair, double> sides;   ///< of the first, along the second
  std::map<Pair, double> votes;   ///< of junctions, for the first hiding the second
  /// Those whose rings arrive there, and those whose rings leave, by what hides them.
  std::map<uint16_t, std::array<std::vector<ContourEnd>, 2>> ends;
};

void add_change(const LabelRing& ring, const RingChange& change, Areas& areas) {
  const Point2 last = ring.sides[(change.at + ring.size() - 1) % ring.size()];
  const bool arrives = change.run_before > near_beside + 1;
  const bool leaves = change.run_after > near_beside + 1;
  if (arrives && change.after != 0)
    areas.ends[change.after][0].push_back(
        {ring.label, change.before, last, (1 / norm(change.in)) * change.in});
  if (leaves && change.before != 0)
    areas.ends[change.before][1].push_back(
        {ring.label, change.after, ring.sides[change.at], (-1 / norm(change.out)) * change.out});
  if (!arrives || !leaves) return;
  const double vote = exact::exp(-std::abs(turn_between(change.in, change.out)) / straight_turn);
  areas.votes[{ring.label, change.before}] += vote;
  areas.votes[{ring.label, change.after}] += vote;
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
    for (const RingChange& change : ring_changes(ring, near_beside, far_beside))
      add_change(ring, change, areas);
  }
  return areas;
}

/// Whether the junctions of two areas say that the first hides the second: contours go straight on
/// in front.
bool hides(const Areas& areas, uint16_t front, uint16_t behind) {
  const auto votes = [&](const Pair& pair) {
    const auto found = areas.votes.find(pair);
    return found == areas.votes.end() ? 0 : found->second;
  };
  const double pro = votes({front, behind});
  const double con = votes({behind, front});
  return pro - con > hiding_vote * (pro + con + silent_votes);
}

/// How a hidden contour from one end to another bends: the energy of a cubic, rad^2, up to a
/// factor, and what of the way lies outside the figure. Infinite where they do not face each other.
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

/// The contour on which two areas go on into each other.
struct Continuation {
  double bend = std::numeric_limits<double>::infinity();
  double gap = 0;  ///< px
};

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

/// Share of an area's contour that is that of what hides it.
double hidden_share(const Areas& areas, uint16_t area) {
  double sides = 0;
  for (auto run = areas.sides.lower_bound({area, 1});
       run != areas.sides.end() && run->first.first == area; ++run)
    if (hides(areas, run->first.second, area)) sides += run->second;
  return sides / areas.perimeter[area];
}

/// Share of the lower one's height that both have.
double beside(const Box2& a, const Box2& b) {
  const double common = std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y);
  const double lower = std::min(a.max.y - a.min.y, b.max.y - b.min.y);
  return std::max(0.0, common) / std::max(1.0, lower);
}

/// Around all areas but one, or but the background where that has no label.
Box2 figure_box(const Areas& areas, uint16_t ground = 0) {
  Box2 box;
  for (size_t label = 1; label < areas.box.size(); ++label)
    if (label != ground && !areas.box[label].empty()) box.add(areas.box[label]);
  return box;
}

/// Whether an area lies on the edge of the picture, or more than hardly on the background.
bool is_open_to(const Areas& areas, uint16_t area, uint16_t ground) {
  const auto touch = areas.sides.find({area, ground});
  return areas.sides.count({area, 0}) > 0 ||
         (touch != areas.sides.end() && touch->second > most_hole_touch * areas.perimeter[area]);
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
    const double a = areas.size.at(pair.first);
    const double b = areas.size.at(pair.second);
    const double hidden =
        std::min(hidden_share(areas, pair.first), hidden_share(areas, pair.second));
    const double odds =
        hidden_weight * hidden +
        beside_weight * beside(areas.box.at(pair.first), areas.box.at(pair.second)) -
        small_part_weight * exact::log(std::min(a, b) / figure) -
        unequal_weight * exact::log(std::max(a, b) / std::min(a, b)) -
        bend_weight * continuation.bend - gap_weight * gap - two_parts;
    if (odds > sure_odds) likely.emplace_back(-odds, pair);
  }
  std::sort(likely.begin(), likely.end());
  std::vector<Pair> pieces;
  for (const auto& [odds, pair] : likely) pieces.push_back(pair);
  return pieces;
}

std::vector<HoleCue> find_holes(const Image16& labels) {
  // The background has a label here, since its contours count as well; 0 is outside the picture.
  const auto ground =
      static_cast<uint16_t>(*std::max_element(labels.pixels.begin(), labels.pixels.end()) + 1);
  Image16 all = labels;
  std::replace(all.pixels.begin(), all.pixels.end(), uint16_t{0}, ground);
  const Areas areas = measure(all);
  const Box2 box = figure_box(areas, ground);
  const double extent = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const auto is_part = [ground](uint16_t label) { return label != 0 && label != ground; };
  std::vector<HoleCue> cues;
  for (const auto& [occluder, ends] : areas.ends)
    for (const ContourEnd& from : ends[0])
      for (const ContourEnd& to : ends[1]) {
        const uint16_t area = std::min(from.area, to.area);
        const bool one_is_ground = area != ground && std::max(from.area, to.area) == ground;
        const bool in_figure = is_part(from.along) && is_part(to.along) && is_part(occluder);
        if (!one_is_ground || !in_figure || is_open_to(areas, area, ground)) continue;
        const double cost =
            bend_weight * bend(all, from, to) + gap_weight * distance(from.at, to.at) / extent;
        if (cost < most_hole_cost) cues.push_back({area, from.along, to.along});
      }
  return cues;
}

}  // namespace relievo::understanding
