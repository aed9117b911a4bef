#pragma once

#include <vector>

#include "io/parts/figures.h"
#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"

namespace relievo {

struct ProposedParts {
  std::vector<Part> parts;      ///< back to front
  std::vector<Palette> colors;  ///< of their topmost fills
};

/// Parts guessed from the figures. Together they cover all that the list covers. None where nothing
/// is drawn.
ProposedParts propose_parts(const FigureList& list);

}  // namespace relievo
