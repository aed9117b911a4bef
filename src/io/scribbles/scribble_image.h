#pragma once

#include "relievo/image.h"
#include "relievo/result.h"
#include "understanding/labels/scribbles.h"

namespace relievo {

/// Reads strokes from a picture painted over the drawing (RGBA, 4 channels, the drawing's size):
///   transparent or white       nothing
///   black                      outside
///   mid grey (128, 128, 128)   hole
///   any other colour           a part; its id is the colour, as "#ff8000"
/// Opaque colours are hard strokes, half transparent ones (alpha 64 to 191) soft. Only colours that
/// fill a square of 3 x 3 px somewhere count, so that the blended rims of strokes do not. Parts are
/// in the order of their first pixels. Connected pixels of one colour become one stroke of width 1
/// that covers exactly them. The scribbles are complete. Errors: `bad_input` where the sizes differ
/// or no colour counts, `limit` above 1000 colours.
Result<understanding::Scribbles> scribbles_from_image(const Image8& rgba, int width, int height);

}  // namespace relievo
