#pragma once

#include "relief/pipeline/build_relief.h"

namespace relievo {

/// The heights and what they are the sum of, h = f + g [P Fig. 4].
enum class Field {
  relief,     ///< h
  inflation,  ///< f
  shift,      ///< g
};

/// Leaves only one of the fields in the relief, in place of h, so that it can be looked at.
/// O(N).
void keep_field(Relief& relief, Field field);

}  // namespace relievo
