#pragma once

#include <vector>

#include "io/svg/path_data.h"

namespace relievo {

/// How much the lines run over each other, as an estimate of the work that a region of them
/// takes: pairs of segments that share a cell of a 64 x 64 grid over their box, summed over the
/// cells. A smooth outline of n points has about n^2 / 100 at most; a scribble over the whole box
/// has about n^2. Preconditions: finite coordinates. O(cells touched).
double tangle(const std::vector<Polyline>& lines);

}  // namespace relievo
