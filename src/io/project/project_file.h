#pragma once

#include <string>
#include <string_view>

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

/// The newest version of project files that is read, and the one that is written.
constexpr int project_version = 1;

/// project.json without the scene, the labels and the drawing's bytes, which are entries of their
/// own.
std::string write_project_json(const Project& project);

/// Reads what write_project_json wrote; keys that only the web editor understands are kept as text.
/// Errors: `bad_input` with the path of the key, `limit`.
Result<Project> read_project_json(std::string_view json);

}  // namespace relievo
