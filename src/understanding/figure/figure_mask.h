#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relievo/image.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {

/// What of the picture is the figure, found without its parts.
struct FigureMask {
  Image8 inside;      ///< [drawing size] 1 where it is; empty where nothing can be said
  bool said = false;  ///< what is outside is background for certain: the picture was cut out
  /// Its rim parts areas, however pale: the picture was cut out, painted on pure white, or is line
  /// art, of which `inside` holds the dark shapes.
  bool sharp = false;
};

/// The figure of a picture on a transparent ground whose opaque areas are it (lines on a
/// transparent ground say nothing), or of paint on paper: what is coloured or dark, the narrow gaps
/// in it but for slits before small holes, and what it surrounds; of line art its dark shapes
/// alone. `rgba` is the drawing, `rgb` the same on white. O(pixels).
FigureMask find_figure(const Image8& rgba, const Image8& rgb, const LineMap& map,
                       bool on_pure_white);

/// Marks the rim of a sharp mask as an edge where no line or edge runs along it. O(pixels).
void mark_rim(const FigureMask& figure, LineMap& map);

}  // namespace relievo::understanding
