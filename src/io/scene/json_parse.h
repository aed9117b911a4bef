#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/scene/json_limits.h"
#include "relievo/result.h"

namespace relievo {

/// Parses strict JSON (RFC 8259; a byte order mark is skipped). Beyond the grammar, it refuses a
/// key that its object already has, and numbers that overflow a double. It does not recurse.
/// Errors: `bad_input` ("malformed JSON ...", with line and column in `where`), `limit`.
Result<nlohmann::json> parse_json(std::string_view text, const JsonLimits& limits = {});

}  // namespace relievo
