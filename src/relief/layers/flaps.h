#pragma once

#include <cstdint>
#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/local_order.h"

namespace relievo {

/// What lies under a part that grows out of it, #F: from the covered side of each join as far as
/// the upper part covers the surface, in front of it. None where the upper outline never leaves
/// that surface, or where what would be left of it has no outline. O(F + faces of the flaps).
std::vector<uint8_t> find_flaps(const BaseMesh& base, const Sheets& sheets,
                                const Connection& connection, const Boundaries& boundaries,
                                const LocalOrder& order, const Scene& scene);

}  // namespace relievo
