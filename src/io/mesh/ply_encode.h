#pragma once

#include <string>

#include "relievo/bytes.h"
#include "relievo/export.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Encodes the model as binary little-endian PLY: mm, longest side `options.size_mm`, right-handed,
/// Y up, front towards +Z, middle at x = y = 0 or grounded. Vertices have x y z nx ny nz s t (v up,
/// as viewers of PLY expect) and, with a drawing, the colour of its texture at that point. A
/// comment names `texture_file` as TextureFile, unless it is empty. Errors: as check_exportable;
/// `usage` for a name of several lines.
Result<Bytes> encode_ply(const Model& model, const Drawing* drawing,
                         const ExportOptions& options = {}, const std::string& texture_file = "");

}  // namespace relievo
