#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "relievo/result.h"

namespace relievo {

/// What a JSON text may ask for; checked while it is read.
struct JsonLimits {
  size_t max_bytes = size_t{64} << 20;
  size_t max_values = 4'000'000;  ///< numbers, strings, arrays, objects and literals together
  size_t max_depth = 32;          ///< of arrays and objects inside each other
};

/// Parses strict JSON (RFC 8259; a byte order mark is skipped). Beyond the grammar, refuses a
/// member name that its object already has, and numbers that overflow a double. Does not recurse.
/// Errors: `bad_input` ("malformed JSON ...", with line and column in `where`), `limit`.
Result<nlohmann::json> parse_json(std::string_view text, const JsonLimits& limits = {});

}  // namespace relievo
