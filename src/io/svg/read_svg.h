#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/svg/svg_options.h"
#include "kernel/geometry/polygon.h"
#include "kernel/image/color.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// A drawing as a renderer of SVG may see it: without joins, cues and what is marked
/// data-relievo="ignore", without scripts, elements that are not SVG's, and pictures other than
/// embedded PNG files of at most 25 million pixels, its root as large as its canvas.
struct PaintableSvg {
  std::string text;
  double width = 0;   ///< of the root in the text, px
  double height = 0;  ///< likewise
};

struct SvgImport {
  Scene scene;
  std::vector<Palette> colors;  ///< [parts]
  std::vector<Point2> anchors;  ///< ends of the curves of its filled paths, canvas px
  bool proposed = false;        ///< the parts were guessed, not annotated
  bool line_art = false;  ///< they were, and nothing is filled: lines enclose them, not shapes
  std::vector<std::string> warnings;
  PaintableSvg paintable;
};

/// Reads a layered drawing (DESIGN 7). Annotated groups, else Inkscape layers, become parts with
/// their joins, cues and relations; a drawing without them gets parts proposed from its shapes.
/// Outlines are cut at the canvas. Fails with bad_input (not SVG, nothing drawn, an annotation
/// that cannot be read), contradiction (an annotation that cannot hold) or limit. Nothing outside
/// the bytes is ever read.
Result<SvgImport> read_svg(std::string_view bytes, const SvgOptions& options = {});

/// The drawing to be painted alone, which need not have parts. Otherwise fails like read_svg.
Result<PaintableSvg> paintable_svg(std::string_view bytes, const SvgOptions& options = {});

}  // namespace relievo
