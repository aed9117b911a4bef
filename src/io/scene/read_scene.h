#pragma once

#include <cstddef>
#include <string_view>

#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

struct SceneLimits {
  size_t max_bytes = size_t{64} << 20;
  size_t max_parts = 1024;
  size_t max_points = 1'000'000;  ///< of all outlines and lines together
};

/// Reads a scene file, version 1 (docs/scene.schema.json). Strict: an unknown, missing or repeated
/// key, a value of the wrong type or out of range, and a part that is not there are refused with
/// `bad_input`; `where` is the path of the key ("parts[2].outline[0][5]"). What is not JSON at all
/// is refused with "malformed JSON". `limit` where it is larger than `limits`. The result is valid
/// (see validate) and its rings are oriented by nesting. Linear in bytes, but for the orientation.
Result<Scene> read_scene(std::string_view json, const SceneLimits& limits = {});

}  // namespace relievo
