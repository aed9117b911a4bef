#pragma once

#include "io/project/project_json.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether an archive states that it is a project file.
bool is_project(ByteView bytes);

/// Encodes the project as a file [docs/project.md]. The same project gives the same bytes. Errors:
/// as write_scene, `internal`.
Result<Bytes> encode_project(const Project& project);

/// Reads a project file. Errors: `bad_input` with the entry and the key, `limit`.
Result<Project> decode_project(ByteView bytes);

}  // namespace relievo
