#pragma once

#include "io/overlay/overlay_svg.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Draws the parts and annotations of a scene over its drawing, as a PNG file. `drawing` is RGBA
/// and covers the canvas; if it is empty, the background is white.
Result<Bytes> draw_overlay(const Scene& scene, const OverlayMarks& marks, const Image8& drawing);

}  // namespace relievo::cli
