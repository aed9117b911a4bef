#pragma once

#include <optional>

#include "relievo/point.h"

namespace relievo {

/// A place where two edges of an outline cross each other, the first along it; none where all
/// rings are simple and meet each other at most at corners. Exact but for the place itself.
/// Near-linear for edges of similar length.
std::optional<Point2> find_self_crossing(const Outline& outline);

}  // namespace relievo
