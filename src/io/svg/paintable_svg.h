#pragma once

#include <string>
#include <string_view>

#include "io/svg/svg_options.h"
#include "relievo/result.h"

namespace relievo {

/// A drawing as a renderer of SVG may see it.
struct PaintableSvg {
  std::string text;
  double width = 0;   ///< of the root in the text, px
  double height = 0;  ///< likewise
};

/// The drawing without joins, cues and what is marked data-relievo="ignore", without scripts,
/// elements that are not SVG's, and pictures other than embedded PNG files of at most 25 million
/// pixels, its root as large as its canvas. Fails like read_svg.
Result<PaintableSvg> paintable_svg(std::string_view bytes, const SvgOptions& options = {});

}  // namespace relievo
