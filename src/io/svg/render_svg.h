#pragma once

#include <cstdint>
#include <functional>

#include "relievo/image.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Rasterises the drawing on a transparent background, its canvas stretched over width x height
/// pixels (both in [1, 16384], at most 100 million pixels together). Paints in a process of its
/// own. Errors: as paint_apart.
Result<Drawing> render_svg(const understanding::PaintableSvg& svg, int width, int height);

/// Limits of a painting process.
struct PaintLimits {
  double seconds = 20;                  ///< of processor time; ten times as much of wall time
  uint64_t memory = uint64_t{1} << 30;  ///< bytes beyond those of this process and the picture
  bool fonts = false;                   ///< may read files: text needs fonts
};

/// Paints in a process of its own, so that this one survives a crash of `paint` and its use of
/// memory. The process writes no file, leaves no dump and ends with this one. `paint` fills width x
/// height RGBA pixels. Errors: those of `paint`; `limit` where it takes too long or too much
/// memory; `bad_input` where it ends in any other way.
Result<Image8> paint_apart(int width, int height, const PaintLimits& limits,
                           const std::function<Status(Image8&)>& paint);

}  // namespace relievo
