#pragma once

namespace relievo {

/// Measures inflated heights in steps that a chord may span.
///
/// On a piece where u is linear, the chord of sqrt(u) between heights a and b departs from it by
/// (b - a)^2 / (4 (a + b)) at most. With the level k of a height defined by |f| = 2 tau k (k + 1)
/// and the sign of f, two heights of the same sign whose levels differ by at most 1 depart by at
/// most tau: levels are dense at the outline, as the profile demands, and spread inwards.
/// A triangle on which sqrt(u) is replaced by its linear interpolant departs by no more than its
/// edge with the widest range, so cutting edges is all that is needed.
class RimLevels {
 public:
  /// `tolerance` > 0, px.
  explicit RimLevels(double tolerance);

  /// Level of sgn(u) sqrt|u|; odd and increasing in u. Exactly 0 for heights so small that they
  /// cannot be told from the outline within the tolerance.
  double level(double u) const;

  /// The height f at a level, px.
  double height(double level) const;

 private:
  double tau_;   ///< tolerance less the share that heights near 0 take
  double flat_;  ///< heights up to this count as 0
};

/// Number of points that cut an edge between two levels so that no piece spans more than one
/// level or a change of sign. Capped at a million.
int cut_count(double first, double last);

/// Level of cut i of `cut_count(first, last)`, counted from `first`. Strictly between both ends
/// and monotone in i; a change of sign is cut at exactly 0.
double cut_level(double first, double last, int i);

}  // namespace relievo
