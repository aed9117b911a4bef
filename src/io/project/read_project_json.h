#pragma once

#include <string_view>

#include "io/project/project.h"
#include "relievo/result.h"

namespace relievo {

/// Reads a text of write_project_json. Keys that only the web editor understands are kept as JSON.
/// Errors: `bad_input` with the path of the key, `limit`.
Result<Project> read_project_json(std::string_view json);

}  // namespace relievo
