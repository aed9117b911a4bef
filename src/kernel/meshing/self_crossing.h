#pragma once

#include <optional>

#include "relievo/point.h"

namespace relievo {

/// Finds the first point along an outline where two of its edges cross; nothing where all rings are
/// simple and meet each other at corners at most. The test is exact, the point is rounded.
/// Near-linear for edges of similar length.
std::optional<Point2> find_self_crossing(const Outline& outline);

}  // namespace relievo
