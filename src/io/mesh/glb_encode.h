#pragma once

#include <string>

#include "relievo/bytes.h"
#include "relievo/export.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Encodes the model as binary glTF 2.0: metres, right-handed, Y up, front towards +Z, longest side
/// `options.size_mm`, middle at x = y = 0 or grounded, drawing plane at z = 0. Every part with
/// faces is a node named by its id with its own compact vertices (equal, also in normals, along
/// seams: readers drop or copy vertices that a mesh shares with others) and extras {part, order, c,
/// d}. A node called `name` holds them; a part that is alone is the root itself and has that name.
/// The scene's extras {canvas, origin, scale} lead back to canvas px: p_canvas = p / scale +
/// origin.
///
/// The drawing (may be null) is embedded as an opaque PNG. The material is double-sided: a relief
/// is open at the back, and its inside must not vanish when it is turned. The same input always
/// gives the same bytes. Errors: as check_exportable; `limit` above 4 GB.
Result<Bytes> encode_glb(const Model& model, const Drawing* drawing,
                         const ExportOptions& options = {}, const std::string& name = "model");

}  // namespace relievo
