#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "relievo/result.h"

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

/// Parses strict JSON (RFC 8259; a byte order mark is skipped). Beyond the grammar, it refuses a
/// key that its object already has, and numbers that overflow a double. It does not recurse.
/// Errors: `bad_input` ("malformed JSON ...", with line and column in `where`), `limit`.
Result<nlohmann::json> parse_json(std::string_view text, const JsonLimits& limits = {});

}  // namespace relievo
