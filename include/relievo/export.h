#pragma once

#include <filesystem>
#include <vector>

#include "relievo/files.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Which programs' way of painting triangles a .3mf has: they do not read each other's.
enum class Slicer {
  prusa,  ///< PrusaSlicer and its kin, by attributes in a namespace of their own
  bambu,  ///< Bambu Studio and OrcaSlicer, by one that the format does not know
};

struct ExportOptions {
  double size_mm = 100;   ///< longest side
  bool standing = false;  ///< .stl and .3mf: what is up on the drawing is up on the bed
  int filaments = 4;      ///< .3mf: at most so many colours are painted, in [1, 16]
  Slicer slicer = Slicer::prusa;
};

/// The files of a model in the format that the ending of `path` says: .glb (metres, Y up, drawing
/// embedded), .obj with its .mtl and .png beside it and .ply (mm, Y up), .stl and of closed models
/// .3mf (mm, Z up, lying on the plate), .usdz (for phones), or .html (a page that shows it). What
/// lies behind other parts has colours of its own, for which the picture is larger than the
/// drawing. The same model gives the same bytes. Errors: `usage` for another ending, or a size or
/// number of filaments out of range, `bad_input` for a model without triangles or extent, `limit`.
Result<std::vector<OutputFile>> export_model(const Model& model, const Drawing& drawing,
                                             const std::filesystem::path& path,
                                             const ExportOptions& options = {});

/// A picture of 1, 3 or 4 channels as a PNG file; the same pixels give the same bytes.
Result<Bytes> encode_picture(const Image8& picture);

}  // namespace relievo
