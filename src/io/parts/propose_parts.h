#pragma once

#include <vector>

#include "io/parts/figures.h"
#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"

namespace relievo {

/// Parts guessed from the figures, back to front. Together they cover all that the list covers.
/// Empty where nothing is drawn.
std::vector<Part> propose_parts(const FigureList& list);

}  // namespace relievo
