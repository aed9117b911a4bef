#pragma once

#include <filesystem>
#include <vector>

#include "relievo/files.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// The program for which the triangles of a .3mf are painted; neither reads the other's paint.
enum class Slicer {
  prusa,  ///< PrusaSlicer and programs derived from it
  bambu,  ///< Bambu Studio and OrcaSlicer
};

struct ExportOptions {
  double size_mm = 100;   ///< longest side
  bool standing = false;  ///< .stl and .3mf: the drawing's up becomes the print bed's up
  int filaments = 4;      ///< .3mf: number of colours painted, at most; in [1, 16]
  Slicer slicer = Slicer::prusa;
};

/// Returns the faces that suit a file: for .stl and .3mf what the front shows, since slicers
/// dislike whole parts, which run through each other; whole parts for other endings.
inline Visibility exported_visibility(const std::filesystem::path& path) {
  const std::filesystem::path ending = path.extension();
  return ending == ".stl" || ending == ".3mf" ? Visibility::relief : Visibility::orbit;
}

/// Encodes a model in the format given by the ending of `path`: .glb (metres, Y up, drawing
/// embedded), .obj with its .mtl and .png, .ply (mm, Y up), .stl and, for closed models, .3mf (mm,
/// Z up, lying on the plate), .usdz (for phones), or .html (a page that shows the model). A surface
/// of Session::model is finished first: inked rims are narrowed, and faces behind other parts get
/// colours of their own, for which the picture is larger than the drawing. The bytes are those of
/// `relievo build`. Errors: `usage` for another ending, or a size or number of filaments out of
/// range, `bad_input` for a model without triangles or extent, `limit`.
Result<std::vector<OutputFile>> export_model(const Model& model, const Drawing& drawing,
                                             const std::filesystem::path& path,
                                             const ExportOptions& options = {});

/// Encodes a picture of 1, 3 or 4 channels as a PNG file. Equal pixels give equal bytes.
Result<Bytes> encode_picture(const Image8& picture);

}  // namespace relievo
