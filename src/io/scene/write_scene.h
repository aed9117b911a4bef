#pragma once

#include <string>

#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// The scene as a file, version 1: the same scene always gives the same bytes, and reading them
/// back gives the same numbers to the last bit. Refuses what validate refuses.
Result<std::string> write_scene(const Scene& scene);

}  // namespace relievo
