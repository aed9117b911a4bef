#pragma once

#include <emscripten/val.h>

#include <cstdint>
#include <string>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo::wasm {

/// Returns {error: {code, message, where, culprit: {list, index}}}, the result of a failed call.
/// The culprit is missing if the error has none.
emscripten::val failure(const Error& error);

/// Copies a Uint8Array.
Bytes to_bytes(const emscripten::val& array);

/// Makes a picture of pixels of 4 bytes each, straight alpha.
Image8 to_image(const emscripten::val& rgba, int width, int height);

/// Makes a drawing of such pixels and recognises pixel art. It is empty if a side is 0.
Drawing to_drawing(const emscripten::val& rgba, int width, int height);

/// Returns the coordinates of points, one after the other.
template <class Point>
std::vector<float> flatten(const std::vector<Point>& points) {
  const auto* numbers = reinterpret_cast<const double*>(points.data());
  return {numbers, numbers + points.size() * (sizeof(Point) / sizeof(double))};
}

/// Copy values to arrays that the page owns.
emscripten::val to_js(const Bytes& bytes);
emscripten::val to_js(const std::vector<float>& numbers);
emscripten::val to_js(const std::vector<uint16_t>& numbers);
emscripten::val to_js(const std::vector<uint32_t>& numbers);
emscripten::val to_js(const std::vector<std::string>& texts);

}  // namespace relievo::wasm
