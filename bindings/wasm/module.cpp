#include <emscripten/bind.h>

#include <string>
#include <string_view>

#include "bindings/wasm/import_layers.h"
#include "bindings/wasm/js_values.h"
#include "bindings/wasm/reconstruction.h"
#include "bindings/wasm/segmenter.h"
#include "io/scene/write_scene.h"
#include "io/svg/read_svg.h"
#include "relief/pipeline/connect_scene.h"

namespace relievo::wasm {
namespace {

using emscripten::val;

/// {scene, proposed, lineArt, warnings, paintable} of a layered drawing: the text of a scene file
/// (see read_svg and connect_scene) and the drawing as the page may paint it (see PaintableSvg).
val import_svg(const val& array) {
  const Bytes bytes = to_bytes(array);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto import = read_svg(text);
  if (!import) return failure(import.error());
  const auto scene =
      write_scene(connect_scene(import->scene, import->proposed, import->colors).scene);
  if (!scene) return failure(scene.error());
  val result = val::object();
  result.set("scene", *scene);
  result.set("paintable", import->paintable.text);
  result.set("proposed", import->proposed);
  result.set("lineArt", import->line_art);
  result.set("warnings", to_js(import->warnings));
  return result;
}

}  // namespace
}  // namespace relievo::wasm

EMSCRIPTEN_BINDINGS(relievo) {
  using relievo::wasm::Reconstruction;
  using relievo::wasm::Segmenter;
  emscripten::function("importSvg", &relievo::wasm::import_svg);
  emscripten::function("checkSegmentation", &relievo::wasm::check_segmentation);
  emscripten::function("importLayers", &relievo::wasm::import_layers);
  emscripten::class_<Reconstruction>("Reconstruction")
      .constructor<>()
      .function("build", &Reconstruction::build)
      .function("surface", &Reconstruction::surface)
      .function("overlays", &Reconstruction::overlays)
      .function("setShown", &Reconstruction::set_shown)
      .function("setTexture", &Reconstruction::set_texture)
      .function("encode", &Reconstruction::encode)
      .function("map", &Reconstruction::map);
  emscripten::class_<Segmenter>("Segmenter")
      .constructor<>()
      .function("openPng", &Segmenter::open_png)
      .function("openPixels", &Segmenter::open_pixels)
      .function("label", &Segmenter::label)
      .function("propose", &Segmenter::propose);
}
