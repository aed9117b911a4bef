#pragma once

#include <vector>

#include "relievo/point.h"

namespace relievo {

/// The polyline with fewer of its points: its ends, and those from which the others depart by at
/// most `tolerance` (Douglas, Peucker 1973). O(n log n) for lines without much detail, O(n^2) at
/// worst.
std::vector<Point2> simplify_line(const std::vector<Point2>& line, double tolerance);

}  // namespace relievo
