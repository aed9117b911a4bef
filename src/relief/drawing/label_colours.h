#pragma once

#include <array>
#include <vector>

#include "relievo/image.h"

namespace relievo {

/// Mean colour of every label of a drawing on white, 0 to 255 a channel, by label from 0 to the
/// largest. Pixels less than 3 px from another label, where outlines run, do not count; a label
/// that has no others is taken whole. `rgba` has the size of `labels`. O(pixels).
std::vector<std::array<double, 3>> label_colours(const Image8& rgba, const Image16& labels);

}  // namespace relievo
