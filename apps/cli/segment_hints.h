#pragma once

#include <string>

#include "io/image/decode_image.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "understanding/labels/scribbles.h"

namespace relievo::cli {

/// Returns an error on a picture `name` whose size is not the drawing's. It names the size before
/// the drawing was enlarged.
Error wrong_size(const FittedImage& drawing, const std::string& name);

/// Reads a picture whose values are the labels of a drawing's parts. It is as large as the drawing
/// or as the drawing's file. Errors: those of decode_png_values, `bad_input` where the size
/// differs.
Result<Image16> read_labels(const std::string& name, const FittedImage& drawing);

/// Reads a mask of the figure of a drawing, as large as labels are. Errors: those of decode_image,
/// `bad_input` where the size differs.
Result<Image8> read_mask(const std::string& name, const FittedImage& drawing);

/// Reads strokes in px of a drawing's file, as a picture or as a scribble file. Errors: those of
/// scribbles_from_image and read_scribbles.
Result<understanding::Scribbles> read_strokes(const std::string& name, const FittedImage& drawing);

}  // namespace relievo::cli
