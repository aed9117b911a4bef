#pragma once

#include <string>

#include "face/inputs.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// A scene of a flat drawing: its parts are found, completed, ordered and joined without a word of
/// the user, and `understood` tells what it was taken for. `file` is the name that is said to the
/// user. Errors: those of segment_drawing and understand_drawing.
Result<SceneInput> understand_flat(Drawing drawing, const std::string& file,
                                   const RunContext& context);

/// The same of a PNG, JPEG or GIF file. Errors: besides, where it cannot be decoded.
Result<SceneInput> read_picture(const InputFile& input, const RunContext& context);

}  // namespace relievo
