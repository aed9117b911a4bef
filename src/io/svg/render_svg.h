#pragma once

#include <string_view>

#include "io/svg/svg_options.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Rasterises the drawing on a transparent ground, its canvas stretched over width x height
/// pixels (both in [1, 16384], at most 100 million pixels together). Joins and what is marked
/// data-relievo="ignore" are not painted. Nothing outside the bytes is read; embedded pictures
/// are painted only where they are PNG files of at most 25 million pixels. Paints in a process of
/// its own (see paint_apart). Fails like read_svg and paint_apart.
Result<Drawing> render_svg(std::string_view bytes, int width, int height,
                           const SvgOptions& options = {});

}  // namespace relievo
