#pragma once

#include "io/project/project.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// Whether an archive says that it is a project file.
bool is_project(ByteView bytes);

/// The project as a file [docs/project.md]. The same project gives the same bytes. Errors: those
/// of its scene (`bad_input`), `internal`.
Result<Bytes> encode_project(const Project& project);

/// Errors: `bad_input` with the entry and the key that is wrong, `limit`.
Result<Project> decode_project(ByteView bytes);

}  // namespace relievo
