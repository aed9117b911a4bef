#pragma once

#include <cstddef>

#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo::understanding {

/// Decides whether undeclared layers are the drawing's parts: they are, unless one of them holds
/// four or more parts of its own (see propose_parts) of which some overlap. Where they are not, the
/// scene loses them, and `paintable` keeps the lines that would have joined them.
void settle_layers(LayeredDrawing& drawing);

/// Completes a drawing that a reader returned: settles its layers, proposes parts from its marks
/// where it declares none, and makes all ids unique. Adds a warning for each mark that is left out.
/// Layers of pixels that have fewer than two silhouettes together make the drawing `flat`. Errors:
/// `bad_input` where nothing opaque is visible, `limit` where parts would have to be proposed from
/// more than `max_marks` marks.
Status make_parts(LayeredDrawing& drawing, size_t max_marks = 2000);

}  // namespace relievo::understanding
