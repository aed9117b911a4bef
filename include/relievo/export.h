#pragma once

#include <filesystem>
#include <vector>

#include "relievo/files.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// The files of a model in the format that the ending of `path` says: .glb (metres, Y up, drawing
/// embedded), .obj with its .mtl and .png beside it and .ply (mm, Y up), or .stl (mm, Z up, lying
/// on the plate). What lies behind other parts has colours of its own, for which the picture is
/// larger than the drawing. The longest side is `size_mm`. The same model gives the same bytes.
/// Errors: `usage` for another ending or a size that is not positive, `bad_input` for a model
/// without triangles or extent, `limit`.
Result<std::vector<OutputFile>> export_model(const Model& model, const Drawing& drawing,
                                             const std::filesystem::path& path,
                                             double size_mm = 100);

/// A picture of 1, 3 or 4 channels as a PNG file; the same pixels give the same bytes.
Result<Bytes> encode_picture(const Image8& picture);

}  // namespace relievo
