#pragma once

#include <vector>

#include "relievo/scene.h"
#include "understanding/marks/figures.h"

namespace relievo::understanding {

/// Proposes the parts of a drawing from its figures, back to front, and sets the `colors` of their
/// topmost fills. Together the parts cover all that the list covers. A frame is one part with the
/// figures that show through its holes, like the ribs and plates of a shell. Returns no parts where
/// nothing is drawn. Parts may lack an id or share one.
std::vector<Part> propose_parts(const FigureList& drawn, std::vector<Palette>& colors);

}  // namespace relievo::understanding
