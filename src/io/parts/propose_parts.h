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

/// Parts guessed from the figures. Together they cover all that the list covers. A frame is one
/// with what shows through its holes, as the ribs and plates of a shell. None where nothing is
/// drawn.
ProposedParts propose_parts(const FigureList& drawn);

}  // namespace relievo
