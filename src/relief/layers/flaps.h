#pragma once

#include <cstdint>
#include <vector>

#include "relief/layers/boundaries.h"

namespace relievo {

/// What lies under a part that grows out of it, #F: from the covered side of each join as far as
/// the upper part covers the surface. None where the upper outline never leaves that surface.
/// O(F + faces of the flaps).
std::vector<uint8_t> find_flaps(const BaseMesh& base, const Sheets& sheets,
                                const Connection& connection, const Boundaries& boundaries);

}  // namespace relievo
