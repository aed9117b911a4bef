#pragma once

#include <string_view>

#include "io/project/project.h"
#include "relievo/result.h"

namespace relievo {

/// Reads what write_project_json wrote; keys that only the web editor understands are kept as text.
/// Errors: `bad_input` with the path of the key, `limit`.
Result<Project> read_project_json(std::string_view json);

}  // namespace relievo
