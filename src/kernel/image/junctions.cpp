#include "kernel/image/junctions.h"

#include <cmath>
#include <numbers>

#include "kernel/base/exact_functions.h"
#include "kernel/geometry/polyline.h"

namespace relievo {
namespace {

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
