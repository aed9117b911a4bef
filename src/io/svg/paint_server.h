#pragma once

#include <optional>

#include "io/svg/svg_document.h"
#include "io/svg/svg_style.h"

namespace relievo {

/// One colour that stands for the paint: its own, or the mean of a gradient's stops along the
/// gradient, or grey for a pattern. A gradient is as transparent as its most transparent stop, for
/// one that fades out is shading. Nothing where the paint draws nothing.
std::optional<Color> representative_color(const SvgPaint& paint, const SvgDocument& document);

}  // namespace relievo
