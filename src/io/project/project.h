#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/corrections/corrections.h"
#include "relievo/bytes.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// The artist's own file.
struct ProjectDrawing {
  std::string name;            ///< file name without folders
  std::string kind = "image";  ///< "image" or "svg"
  std::string mime;            ///< "image/png", "image/jpeg" or "image/svg+xml"
  Bytes bytes;                 ///< untouched
};

/// What a project file holds [docs/project.md].
struct Project {
  std::string name;
  ProjectDrawing drawing;
  std::optional<SegmentationRecord> segmentation;  ///< of a flat drawing
  Scene scene;    ///< the result; its drawing names the entry that covers the canvas
  Bytes picture;  ///< that entry, a PNG or JPEG file; empty where it is the drawing itself
  /// What project.json holds besides, by key, as JSON: the settings and colours of the web editor.
  std::map<std::string, std::string> other_keys;
};

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
