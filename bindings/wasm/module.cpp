#include <emscripten/bind.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bindings/wasm/js_values.h"
#include "bindings/wasm/reconstruction.h"
#include "bindings/wasm/segmenter.h"
#include "io/files/file_kind.h"
#include "io/files/paths.h"
#include "io/image/png.h"
#include "io/layered/layer_files.h"
#include "io/layered/read_ora.h"
#include "io/psd/psd_file.h"
#include "io/psd/read_psd.h"
#include "io/psd/write_psd.h"
#include "io/scene/scene_json.h"
#include "io/svg/read_svg.h"
#include "understanding/marks/make_parts.h"
#include "understanding/marks/paint_gap.h"
#include "understanding/scene/connect_scene.h"

namespace relievo::wasm {
namespace {

using emscripten::val;
using understanding::LayeredDrawing;

/// Returns the text of a scene file with the drawing's parts, connected.
Result<std::string> connected(const LayeredDrawing& drawing) {
  return write_scene(
      understanding::connect_scene(drawing.scene, drawing.proposed, drawing.colors, drawing.anchors)
          .scene);
}

/// Makes the canvas one part, which stands for a picture until it is understood.
void take_whole(Scene& scene) {
  const double width = scene.width;
  const double height = scene.height;
  scene.parts = {{"picture", {{{0, 0}, {width, 0}, {width, height}, {0, height}}}}};
}

/// Imports a layered drawing. Returns {scene, proposed, lineArt, warnings, paintable}: the text of
/// a scene file (see make_parts and connect_scene), and the drawing for the page to paint (see
/// PaintableSvg).
val import_svg(const val& array) {
  const Bytes bytes = to_bytes(array);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto drawing = read_svg(text);
  if (!drawing) return failure(drawing.error());
  if (drawing->flat) take_whole(drawing->scene);
  if (Status status = understanding::make_parts(*drawing); !status) return failure(status.error());
  const auto scene = connected(*drawing);
  if (!scene) return failure(scene.error());
  val result = val::object();
  result.set("scene", *scene);
  result.set("paintable", drawing->paintable.text);
  result.set("proposed", drawing->proposed);
  result.set("lineArt", drawing->line_art || drawing->flat);
  result.set("warnings", to_js(drawing->warnings));
  return result;
}

/// Returns {departs}: whether the shapes of a layered drawing are not those that the page painted
/// of it; see understanding::departs_from_paint. `rgba` shows the whole canvas.
val departs_from_paint(const val& array, const val& rgba, int width, int height) {
  const Bytes bytes = to_bytes(array);
  const auto drawing = read_svg({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!drawing) return failure(drawing.error());
  val result = val::object();
  result.set("departs", understanding::departs_from_paint(*drawing, to_image(rgba, width, height)));
  return result;
}

/// Says what a file is that could not be opened: returns {name, remedy}, or null where nothing is
/// to be said (see file_kind).
val unread_file(const val& array) {
  const FileKind kind = file_kind(to_bytes(array));
  if (kind.remedy.empty() || kind.kind == InputKind::unknown) return val::null();
  val result = val::object();
  result.set("name", std::string(kind.name));
  result.set("remedy", std::string(kind.remedy));
  return result;
}

/// Limits that suit the memory of a page.
const ImageLimits page_limits = {4096 * 4096, 32'767};
const char* const table_name = "layers.tsv";

std::vector<ArchiveEntry> to_entries(const val& files) {
  std::vector<ArchiveEntry> entries;
  const int count = files["length"].as<int>();
  for (int i = 0; i < count; ++i)
    entries.push_back({files[i]["name"].as<std::string>(), to_bytes(files[i]["bytes"])});
  return entries;
}

Result<std::vector<LayerFile>> layers_of(const std::vector<ArchiveEntry>& entries) {
  if (const ArchiveEntry* table = find_entry(entries, table_name)) {
    auto layers =
        read_layer_table({reinterpret_cast<const char*>(table->bytes.data()), table->bytes.size()});
    return layers ? layers : in_file(layers.error(), table_name);
  }
  std::vector<std::string> names;
  for (const ArchiveEntry& entry : entries) names.push_back(entry.name);
  return layers_of_names(std::move(names));
}

Result<LayeredDrawing> read_pictures(const std::vector<ArchiveEntry>& entries) {
  auto layers = layers_of(entries);
  if (!layers) return layers.error();
  for (LayerFile& layer : *layers) {
    const ArchiveEntry* picture = find_entry(entries, layer.file);
    if (picture == nullptr)
      return Error{ErrorCode::file, "is listed in the table of layers, but was not opened with it",
                   layer.file};
    layer.png = picture->bytes;
  }
  return unpack_layers(*layers, {}, {}, page_limits);
}

Result<LayeredDrawing> read_layers(const std::vector<ArchiveEntry>& entries) {
  if (entries.size() == 1 && is_psd(entries[0].bytes))
    return read_psd(entries[0].bytes, page_limits);
  return is_ora(entries) ? read_ora(entries, page_limits) : read_pictures(entries);
}

/// Imports a painted drawing. Returns {scene, proposed, warnings, drawing}: the text of a scene
/// file, missing if the layers are no parts, and the picture, a PNG file. `files` is an array of
/// {name, bytes}: a Photoshop document, the entries of an OpenRaster archive, or transparent
/// pictures, one per layer. These are listed in a layers.tsv among them (see layer_files.h), or
/// else are back to front in the natural order of their names.
val import_layers(const val& files) {
  auto drawing = read_layers(to_entries(files));
  if (!drawing) return failure(drawing.error());
  if (!drawing->flat)
    if (Status status = understanding::make_parts(*drawing); !status)
      return failure(status.error());
  const auto picture = encode_png(drawing->picture.rgba);
  if (!picture) return failure(picture.error());
  val result = val::object();
  result.set("proposed", drawing->proposed);
  result.set("warnings", to_js(drawing->warnings));
  result.set("drawing", to_js(*picture));
  if (drawing->flat) return result;
  const auto scene = connected(*drawing);
  if (!scene) return failure(scene.error());
  result.set("scene", *scene);
  return result;
}

/// Returns {bytes}, a Photoshop document with the parts of a scene, the text of a scene file, as
/// layers.
val encode_layers(const std::string& text, const val& rgba, int width, int height) {
  const auto scene = read_scene(text);
  if (!scene) return failure(scene.error());
  const auto bytes = encode_part_layers(*scene, to_drawing(rgba, width, height));
  if (!bytes) return failure(bytes.error());
  val result = val::object();
  result.set("bytes", to_js(*bytes));
  return result;
}

}  // namespace
}  // namespace relievo::wasm

EMSCRIPTEN_BINDINGS(relievo) {
  using relievo::wasm::Reconstruction;
  using relievo::wasm::Segmenter;
  emscripten::function("importSvg", &relievo::wasm::import_svg);
  emscripten::function("departsFromPaint", &relievo::wasm::departs_from_paint);
  emscripten::function("unreadFile", &relievo::wasm::unread_file);
  emscripten::function("checkSegmentation", &relievo::wasm::check_segmentation);
  emscripten::function("importLayers", &relievo::wasm::import_layers);
  emscripten::function("encodeLayers", &relievo::wasm::encode_layers);
  emscripten::class_<Reconstruction>("Reconstruction")
      .constructor<>()
      .function("build", &Reconstruction::build)
      .function("surface", &Reconstruction::surface)
      .function("dressed", &Reconstruction::dressed)
      .function("overlays", &Reconstruction::overlays)
      .function("setShown", &Reconstruction::set_shown)
      .function("setTexture", &Reconstruction::set_texture)
      .function("encode", &Reconstruction::encode)
      .function("solid", &Reconstruction::solid)
      .function("encodeSolid", &Reconstruction::encode_solid)
      .function("map", &Reconstruction::map);
  emscripten::class_<Segmenter>("Segmenter")
      .constructor<>()
      .function("openPng", &Segmenter::open_png)
      .function("openPixels", &Segmenter::open_pixels)
      .function("label", &Segmenter::label)
      .function("propose", &Segmenter::propose);
}
