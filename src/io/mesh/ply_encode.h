#pragma once

#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

struct PlyOptions {
  double size_mm = 100;      ///< longest side
  std::string texture_file;  ///< named in a comment as TextureFile; none where empty
};

/// The model as binary little-endian PLY: mm, right-handed, Y up, front towards +Z, middle at
/// x = y = 0. Vertices have x y z nx ny nz s t (v up, as viewers of PLY expect) and, where there
/// is a drawing, the colour of its texture at that point. Errors: as check_exportable.
Result<Bytes> encode_ply(const Model& model, const Drawing* drawing,
                         const PlyOptions& options = {});

}  // namespace relievo
