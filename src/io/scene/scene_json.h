#pragma once

#include <string>
#include <string_view>

#include "io/scene/json_limits.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// Reads a scene file, version 1 (docs/scene.schema.json). Unknown, missing and repeated keys,
/// values of a wrong type or out of range, and unknown parts are refused with `bad_input`; `where`
/// is the path of the key ("parts[2].outline[0][5]"). A text that is not JSON is refused with
/// "malformed JSON", one larger than `limits` with `limit`. The scene is valid (see validate), and
/// its rings are oriented by nesting. Linear in bytes, but for the orientation.
Result<Scene> read_scene(std::string_view json, const JsonLimits& limits = {});

/// Returns the scene as a file, version 1. The same scene always gives the same bytes, and reading
/// them back gives the same numbers to the last bit. Errors: as validate.
Result<std::string> write_scene(const Scene& scene);

}  // namespace relievo
