#pragma once

#include <Eigen/Core>
#include <vector>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"

namespace relievo::relief {

/// Returns 0 up to `from`, 1 from `to` on, and a cubic between.
double smooth_step(double from, double to, double x);

/// Returns all joins, sorted by their upper parts. O(J log J).
std::vector<Join> joins_by_upper(const Scene& scene);

/// Returns the part, then all parts that grow out of it. O(J + parts).
std::vector<int> grown_from(int part, const std::vector<Join>& by_upper, size_t parts);

/// Returns the shift that lets joined limbs hang straight, #N in scene units, 0 off limbs. At its
/// root a limb is as high as what it grows out of, because f is one surface. Further away it is as
/// high as its own width makes it, so it would lean back. The shift is
///   r = A smoothstep(x / l),   A = s min(F, 1.5 k).
/// x is a distance to the root without ridges, so that the surface stays smooth. F is how much
/// lower the crest is in the outer part of the limb than at the root, and k its height there. l is
/// the distance at which the crest has come down, at least 1.5 widths of the root. s grows from 0
/// for limbs as long as their root is wide to 1 at 1.75 widths. Parts growing out of the limb
/// follow. Limbs with a lean are left out. O(N + F) in all, O(N) for each limb, and its nodes times
/// the square root of its root's.
Eigen::VectorXd limb_rise(const SurfaceInput& surface, const Inflation& inflation);

}  // namespace relievo::relief
