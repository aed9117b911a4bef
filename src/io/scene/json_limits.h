#pragma once

#include <cstddef>

namespace relievo {

/// Limits of a JSON file, checked while it is read.
struct JsonLimits {
  size_t max_bytes = size_t{64} << 20;
  size_t max_values = 4'000'000;  ///< numbers, strings, arrays, objects and literals together
  size_t max_depth = 32;          ///< of nested arrays and objects
  size_t max_points = 1'000'000;  ///< of all outlines, lines and strokes together
  size_t max_parts = 1024;        ///< of a scene
  size_t max_strokes = 100'000;   ///< of scribbles
};

}  // namespace relievo
