#pragma once

#include "relief/pipeline/build_relief.h"

namespace relievo {

/// Leaves only one of the fields in the relief, in place of h, so that it can be looked at.
/// O(N).
void keep_field(Relief& relief, Field field);

}  // namespace relievo
