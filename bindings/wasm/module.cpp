#include <emscripten/bind.h>

#include <string>
#include <string_view>
#include <vector>

#include "bindings/wasm/import_layers.h"
#include "bindings/wasm/js_values.h"
#include "bindings/wasm/reconstruction.h"
#include "io/scene/write_scene.h"
#include "io/svg/paintable_svg.h"
#include "io/svg/read_svg.h"
#include "relief/drawing/segment_drawing.h"
#include "relief/pipeline/propose_scene.h"

namespace relievo::wasm {
namespace {

using emscripten::val;

/// {scene, proposed, warnings, paintable} of a layered drawing: the text of a scene file (see
/// read_svg) and the drawing as the page may paint it (see paintable_svg).
val import_svg(const val& array) {
  const Bytes bytes = to_bytes(array);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto import = read_svg(text);
  if (!import) return failure(import.error());
  const auto paintable = paintable_svg(text);
  if (!paintable) return failure(paintable.error());
  const auto scene = write_scene(import->scene);
  if (!scene) return failure(scene.error());
  val result = val::object();
  result.set("scene", *scene);
  result.set("paintable", paintable->text);
  result.set("proposed", import->proposed);
  result.set("warnings", to_js(import->warnings));
  return result;
}

/// {scene, warnings} of a flat drawing whose parts are guessed: the text of a scene file whose
/// canvas is the picture, 4 bytes a pixel, straight alpha. See segment_drawing and propose_scene.
val import_picture(const val& rgba, int width, int height) {
  Drawing drawing;
  drawing.rgba.width = width;
  drawing.rgba.height = height;
  drawing.rgba.channels = 4;
  drawing.rgba.pixels = to_bytes(rgba);
  const auto segmentation = segment_drawing(drawing);
  if (!segmentation) return failure(segmentation.error());
  const auto proposal = propose_scene(segmentation->labels);
  if (!proposal) return failure(proposal.error());
  const auto scene = write_scene(proposal->scene);
  if (!scene) return failure(scene.error());
  std::vector<std::string> warnings = segmentation->notes;
  warnings.insert(warnings.end(), proposal->warnings.begin(), proposal->warnings.end());
  val result = val::object();
  result.set("scene", *scene);
  result.set("warnings", to_js(warnings));
  return result;
}

}  // namespace
}  // namespace relievo::wasm

EMSCRIPTEN_BINDINGS(relievo) {
  using relievo::wasm::Reconstruction;
  emscripten::function("importSvg", &relievo::wasm::import_svg);
  emscripten::function("importPicture", &relievo::wasm::import_picture);
  emscripten::function("importLayers", &relievo::wasm::import_layers);
  emscripten::class_<Reconstruction>("Reconstruction")
      .constructor<>()
      .function("build", &Reconstruction::build)
      .function("surface", &Reconstruction::surface)
      .function("overlays", &Reconstruction::overlays)
      .function("setTexture", &Reconstruction::set_texture)
      .function("encode", &Reconstruction::encode)
      .function("map", &Reconstruction::map);
}
