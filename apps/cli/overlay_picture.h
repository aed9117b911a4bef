#pragma once

#include "io/overlay/overlay_svg.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo::cli {

/// What was understood of a drawing, over it, as a PNG file. `drawing` has 4 channels and covers
/// the canvas; where it is empty the ground is white.
Result<Bytes> draw_overlay(const Scene& scene, const OverlayMarks& marks, const Image8& drawing);

}  // namespace relievo::cli
