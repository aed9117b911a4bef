#pragma once

#include <Eigen/Core>
#include <vector>

#include "relief/inflation/inflation.h"
#include "relief/ordering/ordering_system.h"

namespace relievo::relief {

/// 0 up to `from`, 1 from `to` on, a cubic between.
double smooth_step(double from, double to, double x);

/// All joins, ascending by their upper parts. O(J log J).
std::vector<Join> joins_by_upper(const Scene& scene);

/// The part, then all that grows out of it. O(J + parts).
std::vector<int> grown_from(int part, const std::vector<Join>& by_upper, size_t parts);

/// The shift by which joined limbs hang straight, #N in scene units, 0 but on them. At its root a
/// limb is as high as what it grows out of, f being one surface, and away from there as its own
/// width makes it, so that it would lean back. Let F be how much lower its crest is in the last
/// part of its reach than at the root. Everything on the limb comes forward by
///   A smoothstep(x / l),  A = s min(F, 1.5 crest there),
/// x the distance to the root, without ridges, so that the surface stays smooth there, and l where
/// the crest has come down, at least 1.5 widths of the root; what grows out of the limb comes
/// along. s leaves lumps alone: from 0 to 1 for limbs that reach one to 1.75 widths of their root.
/// Limbs with a lean stay. O(N + F) in all, O(N) for each limb, and its nodes times the square root
/// of its root's.
Eigen::VectorXd limb_rise(const SurfaceInput& surface, const Inflation& inflation);

}  // namespace relievo::relief
