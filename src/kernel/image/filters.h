#pragma once

#include <cstdint>
#include <limits>

namespace relievo {

/// What squared_distance_to says everywhere where the mask is empty.
constexpr int32_t no_distance = std::numeric_limits<int32_t>::max();

}  // namespace relievo
