#pragma once

#include <vector>

#include "relievo/scene.h"
#include "understanding/marks/silhouettes.h"

namespace relievo::understanding {

/// Proposes the parts of a drawing from its silhouettes, back to front, and sets the `colors` of
/// their topmost fills. Together the parts cover all that the list covers. A frame is one part with
/// the silhouettes that show through its holes, like the ribs and plates of a shell. Returns no
/// parts where nothing is drawn. Parts may lack an id or share one.
std::vector<Part> propose_parts(const SilhouetteList& drawn, std::vector<Palette>& colors);

}  // namespace relievo::understanding
