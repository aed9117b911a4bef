#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "relievo/image.h"

namespace relievo::understanding {

/// The pairs of labels, smaller one first, along most of whose common border the drawing shows
/// nothing, neither a line nor a change of colour: what they are of has grown together there.
/// `rgba` has the size of `labels`. O(pixels).
std::vector<std::pair<uint16_t, uint16_t>> open_borders(const Image8& rgba, const Image16& labels);

}  // namespace relievo::understanding
