#pragma once

#include <string>

#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// Returns the scene as a file, version 1. The same scene always gives the same bytes, and reading
/// them back gives the same numbers to the last bit. Errors: as validate.
Result<std::string> write_scene(const Scene& scene);

}  // namespace relievo
