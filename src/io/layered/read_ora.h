#pragma once

#include <functional>
#include <vector>

#include "io/archive/archive.h"
#include "io/image/image_limits.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Paints an SVG file at its own size. Errors: those of the painter.
using PaintSvg = std::function<Result<Image8>(const Bytes& svg)>;

/// Returns whether the archive states that it is an OpenRaster file.
bool is_ora(const std::vector<ArchiveEntry>& entries);

/// Reads an OpenRaster drawing (see read_layer_name and compose_layers). Hidden layers are left
/// out. Unknown blending modes are painted as source-over, with a warning that names the layer. A
/// group is composed on its own unless it states `isolation="auto"` and has neither opacity nor
/// blending. Layers that are vector drawings are painted by `paint_svg`. The merged picture is
/// taken, with a warning, where the layers show nothing, or one is a vector drawing and nothing
/// paints it. Errors name the entry: `bad_input`, `limit`, those of `paint_svg`.
Result<understanding::LayeredDrawing> read_ora(const std::vector<ArchiveEntry>& entries,
                                               const ImageLimits& limits = {},
                                               const PaintSvg& paint_svg = nullptr);

}  // namespace relievo
