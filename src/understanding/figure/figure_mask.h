#pragma once

#include "relievo/image.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {

/// The pixels of the figure, found before its parts.
struct FigureMask {
  Image8 inside;  ///< [drawing size] 1 on the figure; empty where it is unknown
  /// The drawing is transparent outside the mask, which is therefore certainly background.
  bool cut_out = false;
  /// The mask's rim separates areas even where both sides are pale. True if the drawing was cut
  /// out, was painted on pure white, or is line art, of which the mask holds the dark shapes only.
  bool sharp = false;
};

/// Finds the figure. On transparency it is the opaque areas; where these are lines only, nothing is
/// known. On paper it is the paint: coloured or dark pixels, the narrow gaps between them (except
/// slits in front of small holes), and everything that they enclose. Of line art it is the dark
/// shapes. `rgba` is the drawing, `rgb` the same on white. O(pixels).
FigureMask find_figure(const Image8& rgba, const Image8& rgb, const LineMap& map,
                       bool on_pure_white);

/// Marks the rim of a sharp mask as an edge where no line or edge runs along it. O(pixels).
void mark_rim(const FigureMask& figure, LineMap& map);

}  // namespace relievo::understanding
