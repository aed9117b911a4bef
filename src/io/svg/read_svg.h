#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/parts/color.h"
#include "io/svg/svg_options.h"
#include "kernel/geometry/polygon.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

struct SvgImport {
  Scene scene;
  std::vector<Palette> colors;  ///< [parts]
  bool proposed = false;        ///< the parts were guessed, not annotated
  bool line_art = false;  ///< they were, and nothing is filled: lines enclose them, not shapes
  std::vector<std::string> warnings;
};

/// Reads a layered drawing (DESIGN 7). Annotated groups, else Inkscape layers, become parts with
/// their joins, cues and relations; a drawing without them gets parts proposed from its shapes.
/// Outlines are cut at the canvas. Fails with bad_input (not SVG, nothing drawn, an annotation
/// that cannot be read), contradiction (an annotation that cannot hold) or limit. Nothing outside
/// the bytes is ever read.
Result<SvgImport> read_svg(std::string_view bytes, const SvgOptions& options = {});

}  // namespace relievo
