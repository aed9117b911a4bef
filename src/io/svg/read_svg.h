#pragma once

#include <string_view>

#include "io/svg/svg_options.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Reads a layered drawing (DESIGN 7). Groups that are annotated as parts, else all Inkscape layers
/// of a drawing with a join or a cue, are declared parts. Two or more Inkscape layers of any other
/// drawing are parts too, but undeclared (LayeredDrawing::layers). Outlines are cut at the canvas.
/// Nothing outside the bytes is ever read. Errors: `bad_input` (not SVG, or an annotation that
/// cannot be read), `contradiction` (an annotation that cannot hold), `limit`.
Result<understanding::LayeredDrawing> read_svg(std::string_view bytes,
                                               const SvgOptions& options = {});

}  // namespace relievo
