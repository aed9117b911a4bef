#pragma once

#include <string>

#include "api/inputs.h"
#include "io/image/decode_image.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// Says by how much a picture was reduced or enlarged; nothing where it was not.
std::string fitting_note(const FittedImage& picture);

/// Makes the scene of a flat drawing: parts are found, completed, ordered and, if `connect`, joined
/// without help, and `understood` describes the result. `file`: name of the drawing for messages.
/// Errors: those of segment_drawing and understand_drawing.
Result<SceneInput> understand_flat(Drawing drawing, const std::string& file, bool connect,
                                   const RunContext& context);

/// Makes the scene of a picture as understand_flat does, and says in `understood` how the picture
/// was fitted.
Result<SceneInput> understand_fitted(FittedImage picture, const std::string& file, bool connect,
                                     const RunContext& context);

/// Makes the scene of a picture file (see decode_fitted) as understand_fitted does. Of an
/// animation the first frame is used, with a warning. Errors: as there, and `bad_input` if the file
/// cannot be decoded.
Result<SceneInput> read_picture(const InputFile& input, bool connect, const RunContext& context);

}  // namespace relievo
