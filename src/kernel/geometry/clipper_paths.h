#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

#include "kernel/geometry/region.h"

namespace relievo {

/// Clipper computes with integers: coordinates are rounded to 1/1024 px.
constexpr double clipper_units_per_px = 1024;

/// The largest distance of a rounded corner made by Clipper from the true arc, in its units.
constexpr double clipper_arc_tolerance = 0.05 * clipper_units_per_px;

/// Returns the ring in units of Clipper. O(n).
ClipperLib::Path to_path(const Ring& ring);

/// Returns all rings of the region in units of Clipper. O(n).
ClipperLib::Paths to_paths(const Region& region);

/// Returns the paths as rings in px. Drops those of less than three points. O(n).
Region to_region(const ClipperLib::Paths& paths);

/// Computes a boolean operation of two sets of paths. The subject is filled by `rule`, the clip by
/// the non-zero rule. A `simple` result has no two equal points. O(n log n + crossings).
ClipperLib::Paths combine(ClipperLib::ClipType operation, const ClipperLib::Paths& subject,
                          const ClipperLib::Paths& clip,
                          ClipperLib::PolyFillType rule = ClipperLib::pftNonZero,
                          bool simple = false);

/// Computes an operation by the non-zero rule. Returns the pieces of its result, each an outer path
/// with the paths of its holes. O(n log n + crossings).
std::vector<ClipperLib::Paths> pieces_of(ClipperLib::ClipType operation,
                                         const ClipperLib::Paths& subject,
                                         const ClipperLib::Paths& clip);

/// Computes the points within a distance of closed paths, in their units; a negative distance
/// shrinks them. Corners are round, `tolerance` from the true arc at most. O(n log n + crossings).
ClipperLib::Paths grow_paths(const ClipperLib::Paths& paths, double distance, double tolerance);

}  // namespace relievo
