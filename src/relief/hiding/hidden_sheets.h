#pragma once

#include "relief/inflation/inflation.h"
#include "relief/ordering/ordering.h"

namespace relievo::relief {

/// Inflation and order of all sheets, hidden ones included.
struct HiddenSheets {
  Inflation inflation;
  Ordering ordering;
  int overlap_samples = 0;   ///< faces that still come out in front of the next one
  double overlap_worst = 0;  ///< and by how much at most, px
};

}  // namespace relievo::relief
