#pragma once

#include <emscripten/val.h>

namespace relievo::wasm {

/// {scene, proposed, warnings, drawing}: the text of a scene file and the picture, a PNG file, of a
/// painted drawing. `files` is an array of {name, bytes}: the entries of an OpenRaster archive, or
/// transparent pictures, one a layer, as a layers.tsv among them says (see layer_table.h), else
/// back to front in the natural order of their names.
emscripten::val import_layers(const emscripten::val& files);

}  // namespace relievo::wasm
