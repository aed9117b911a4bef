#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"
#include "understanding/marks/figures.h"

namespace relievo::understanding {

struct ProposedParts {
  std::vector<Part> parts;      ///< back to front
  std::vector<Palette> colors;  ///< of their topmost fills
};

/// Parts guessed from the figures. Together they cover all that the list covers. A frame is one
/// with what shows through its holes, as the ribs and plates of a shell. None where nothing is
/// drawn.
ProposedParts propose_parts(const FigureList& drawn);

}  // namespace relievo::understanding
