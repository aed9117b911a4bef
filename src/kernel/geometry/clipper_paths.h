#pragma once

#include <polyclipping/clipper.hpp>

#include "kernel/geometry/region.h"

namespace relievo {

/// Clipper computes with integers; coordinates are rounded to 1/1024 px.
constexpr double clipper_units_per_px = 1024;

/// A circle drawn by Clipper departs from the true one by less than this, in its units.
constexpr double clipper_arc_tolerance = 0.05 * clipper_units_per_px;

ClipperLib::Path to_path(const Ring& ring);
ClipperLib::Paths to_paths(const Region& region);

/// The paths as rings; those of less than three points are dropped.
Region to_region(const ClipperLib::Paths& paths);

/// A boolean operation; `rule` is that of the subject, the clip is filled by the non-zero rule.
/// A `simple` result has no two equal points.
ClipperLib::Paths combine(ClipperLib::ClipType operation, const ClipperLib::Paths& subject,
                          const ClipperLib::Paths& clip,
                          ClipperLib::PolyFillType rule = ClipperLib::pftNonZero,
                          bool simple = false);

}  // namespace relievo
