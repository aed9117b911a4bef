#pragma once

#include <filesystem>
#include <optional>
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

/// Bounds of ExportOptions::texture_size, px.
constexpr int least_texture_size = 16;
constexpr int max_texture_size = 32768;
/// Bounds of factors for the width of contours.
constexpr double least_ink_width = 0.1;
constexpr double most_ink_width = 10;

struct ExportOptions {
  double size_mm = 100;   ///< longest side
  bool grounded = false;  ///< .glb, .obj and .ply: the lowest point is at y = 0
  int texture_size = 0;   ///< px, longest side of the texture at most, by whole factors; 0: any
  bool standing = false;  ///< .stl and .3mf: the drawing's up becomes the print bed's up
  int filaments = 4;      ///< .3mf: number of colours painted, at most; in [1, 16]
  Slicer slicer = Slicer::prusa;
  std::optional<Ink> ink{};  ///< of a surface to be finished; default: usual_ink
  double ink_width = 1;      ///< factor by which its shells are wider than the contours drawn
};

/// Returns whether a file is for a printer, which needs a closed body (Session::solid): .stl and
/// .3mf.
inline bool is_for_print(const std::filesystem::path& path) {
  const std::filesystem::path ending = path.extension();
  return ending == ".stl" || ending == ".3mf";
}

/// Returns whether a file can hold lines that are seen from one side alone: .glb, .usdz and .html.
inline bool holds_shells(const std::filesystem::path& path) {
  const std::filesystem::path ending = path.extension();
  return ending == ".glb" || ending == ".usdz" || ending == ".html";
}

/// Returns the treatment of contours in a file if no other is chosen: shells where it can hold
/// them, none where it is for a printer, paint in others.
inline Ink usual_ink(const std::filesystem::path& path) {
  return holds_shells(path) ? Ink::shell : is_for_print(path) ? Ink::none : Ink::paint;
}

/// Encodes a model in the format given by the ending of `path`: .glb (metres, Y up, drawing
/// embedded, the root node named after the file), .obj with its .mtl and .png, .ply (mm, Y up),
/// .stl and, for closed models, .3mf (mm, Z up, lying on the plate), .usdz (for phones), or .html
/// (a page that shows the model). A surface of Session::model is finished first: contours
/// become lines (Ink), and faces behind other parts get colours of their own, for which the picture
/// is larger than the drawing. The bytes are those of `relievo build`. Errors: `usage` for another
/// ending, or a size or number out of range, `bad_input` for a model without triangles or extent,
/// `limit`.
Result<std::vector<OutputFile>> export_model(const Model& model, const Drawing& drawing,
                                             const std::filesystem::path& path,
                                             const ExportOptions& options = {});

/// Encodes a picture of 1, 3 or 4 channels as a PNG file. Equal pixels give equal bytes.
Result<Bytes> encode_picture(const Image8& picture);

}  // namespace relievo
