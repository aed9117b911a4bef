#include "bindings/wasm/js_values.h"

#include "relievo/pixel_art.h"

namespace relievo::wasm {
namespace {

using emscripten::val;

template <class T>
val copy(const char* type, const std::vector<T>& values) {
  return val::global(type).new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

/// The names of ErrorCode, in its order.
constexpr const char* code_names[] = {"internal", "usage", "bad_input",  "contradiction",
                                      "limit",    "file",  "interrupted"};

}  // namespace

val failure(const Error& error) {
  val what = val::object();
  what.set("code", std::string(code_names[static_cast<int>(error.code)]));
  what.set("message", error.message);
  what.set("where", error.where);
  if (error.culprit.list != CulpritList::none) {
    val culprit = val::object();
    culprit.set("list", std::string(culprit_list_names[static_cast<int>(error.culprit.list)]));
    culprit.set("index", static_cast<double>(error.culprit.index));
    what.set("culprit", culprit);
  }
  val result = val::object();
  result.set("error", what);
  return result;
}

Bytes to_bytes(const val& array) {
  return emscripten::convertJSArrayToNumberVector<uint8_t>(array);
}

Image8 to_image(const val& rgba, int width, int height) {
  Image8 image;
  image.width = width;
  image.height = height;
  image.channels = 4;
  image.pixels = to_bytes(rgba);
  return image;
}

Drawing to_drawing(const val& rgba, int width, int height) {
  if (width < 1 || height < 1) return {};
  Drawing drawing{to_image(rgba, width, height)};
  drawing.pixel_art = own_pixels(drawing.rgba);
  return drawing;
}

val to_js(const Bytes& bytes) { return copy("Uint8Array", bytes); }
val to_js(const std::vector<float>& numbers) { return copy("Float32Array", numbers); }
val to_js(const std::vector<uint16_t>& numbers) { return copy("Uint16Array", numbers); }
val to_js(const std::vector<uint32_t>& numbers) { return copy("Uint32Array", numbers); }

val to_js(const std::vector<std::string>& texts) {
  val list = val::array();
  for (size_t i = 0; i < texts.size(); ++i) list.set(i, texts[i]);
  return list;
}

}  // namespace relievo::wasm
