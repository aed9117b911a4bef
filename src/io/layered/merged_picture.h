#pragma once

#include <string>

#include "relievo/image.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Returns whether all pixels are the same: a program stored no merged picture, or there is
/// nothing.
bool is_blank(const Image8& rgba);

/// Makes the drawing a flat one, of the merged picture that a program stored with its layers. The
/// warning gives the reason: "no layer has pixels".
void take_merged(understanding::LayeredDrawing& drawing, Image8 merged, const std::string& reason);

/// Compares what was read of the layers with the merged picture, which is as large. Where their
/// areas differ by more than a few per cent, the drawing becomes a flat one (see take_merged).
/// Where only colours differ, the merged picture becomes the texture, with a warning. Returns
/// whether the merged picture was taken. O(pixels).
bool compare_with_merged(understanding::LayeredDrawing& drawing, Image8 merged);

}  // namespace relievo
