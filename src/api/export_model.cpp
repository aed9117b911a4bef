#include <algorithm>
#include <string>
#include <utility>

#include "io/image/png.h"
#include "io/image/row_average.h"
#include "io/mesh/glb_encode.h"
#include "io/mesh/html_encode.h"
#include "io/mesh/obj_encode.h"
#include "io/mesh/ply_encode.h"
#include "io/mesh/stl_encode.h"
#include "io/mesh/threemf_encode.h"
#include "io/mesh/usdz_encode.h"
#include "relief/finish/finish_model.h"
#include "relievo/export.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

using Files = std::vector<OutputFile>;

Result<Files> single(const fs::path& path, Result<Bytes> bytes) {
  if (!bytes) return bytes.error();
  return Files{{path, std::move(*bytes)}};
}

Result<Files> obj_files(const Model& model, const Drawing* drawing, const fs::path& path,
                        const ExportOptions& options) {
  const std::string stem = path.stem().string();
  auto encoded = encode_obj(model, drawing, options, stem);
  if (!encoded) return encoded.error();
  const fs::path beside = path.parent_path() / obj_file_name(stem);
  Files files = {{path, std::move(encoded->obj)},
                 {fs::path(beside) += ".mtl", std::move(encoded->mtl)}};
  if (!encoded->png.empty()) files.push_back({fs::path(beside) += ".png", std::move(encoded->png)});
  return files;
}

/// Returns the whole factor by which a drawing is reduced for its texture. Pixel art is not, since
/// averages would be colours that it does not have.
int texture_reduction(const Drawing& drawing, int texture_size) {
  const int side = std::max(drawing.rgba.width, drawing.rgba.height);
  return texture_size == 0 || drawing.pixel_art > 0 ? 1 : reduced_side(side, texture_size);
}

Result<Files> encode_as(const fs::path& path, const Model& model, const Drawing& drawing,
                        const ExportOptions& options) {
  const int factor = texture_reduction(drawing, options.texture_size);
  const Drawing reduced = factor > 1 ? Drawing{averaged(drawing.rgba, factor)} : Drawing{};
  const Drawing* texture = drawing.rgba.empty() ? nullptr : factor > 1 ? &reduced : &drawing;
  const double size = options.size_mm;
  const std::string name = path.stem().string();
  const fs::path ending = path.extension();
  if (ending == ".obj") return obj_files(model, texture, path, options);
  if (ending == ".ply") return single(path, encode_ply(model, texture, options));
  if (ending == ".stl") return single(path, encode_stl(model, size, options.standing));
  if (ending == ".glb") return single(path, encode_glb(model, texture, options, name));
#ifndef __EMSCRIPTEN__  // a page packs the files of threemf_entries itself
  if (ending == ".3mf") return single(path, encode_3mf(model, texture, options));
#endif
  if (ending == ".usdz") return single(path, encode_usdz(model, texture, size));
  if (ending == ".html") return single(path, encode_html(model, texture, name));
  return Error{ErrorCode::usage, "must end in .glb, .obj, .ply, .stl, .3mf, .usdz or .html",
               path.string()};
}

Status check_options(const ExportOptions& options) {
  if (options.filaments < 1 || options.filaments > 16)
    return Error{ErrorCode::usage, "must be from 1 to 16", "filaments"};
  if (!(options.ink_width >= least_ink_width && options.ink_width <= most_ink_width))
    return Error{ErrorCode::usage, "must be from 0.1 to 10", "ink_width"};
  if (options.texture_size != 0 &&
      (options.texture_size < least_texture_size || options.texture_size > max_texture_size))
    return Error{ErrorCode::usage,
                 "must be from " + std::to_string(least_texture_size) + " to " +
                     std::to_string(max_texture_size) + ", or 0 for the drawing's own",
                 "texture_size"};
  return Done{};
}

}  // namespace

Result<Files> export_model(const Model& model, const Drawing& drawing, const fs::path& path,
                           const ExportOptions& options) {
  if (Status status = check_options(options); !status) return status.error();
  const Ink ink = options.ink.value_or(usual_ink(path));
  if (ink == Ink::shell && !holds_shells(path))
    return Error{ErrorCode::usage,
                 "shells of ink need .glb, .usdz or .html: choose paint or none for others",
                 "--ink"};
  if (!model.unfinished) return encode_as(path, model, drawing, options);
  const relief::DrawnModel finished = relief::finish_model(model, drawing, ink, options.ink_width);
  return encode_as(path, finished.model, finished.drawing, options);
}

Result<Bytes> encode_picture(const Image8& picture) { return encode_png(picture); }

}  // namespace relievo
