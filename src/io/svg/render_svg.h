#pragma once

#include <string_view>

#include "io/svg/read_svg.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Rasterises the drawing on a transparent ground, its canvas stretched over width x height
/// pixels (both in [1, 16384], at most 100 million pixels together). Paints in a process of its
/// own (see paint_apart) and fails like that.
Result<Drawing> render_svg(const PaintableSvg& svg, int width, int height);

/// Likewise what paintable_svg makes of a file.
Result<Drawing> render_svg(std::string_view bytes, int width, int height,
                           const SvgOptions& options = {});

}  // namespace relievo
