#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "relievo/bytes.h"
#include "relievo/result.h"
#include "relievo/scene.h"
#include "understanding/scene/segmentation_record.h"

namespace relievo {

/// The artist's own file.
struct ProjectDrawing {
  std::string name;            ///< file name without folders
  std::string kind = "image";  ///< "image" or "svg"
  std::string mime;            ///< "image/png", "image/jpeg" or "image/svg+xml"
  Bytes bytes;                 ///< as the artist saved it
};

/// The content of a project file [docs/project.md].
struct Project {
  std::string name;
  ProjectDrawing drawing;
  std::optional<understanding::SegmentationRecord> segmentation;  ///< of a flat drawing
  Scene scene;    ///< the result; its drawing names the entry that covers the canvas
  Bytes picture;  ///< that entry, a PNG or JPEG file; empty where it is the drawing itself
  /// Further keys of project.json, as JSON: the settings and colours of the web editor.
  std::map<std::string, std::string> other_keys;
};

/// The newest version of project files that is read, and the one that is written.
constexpr int project_version = 1;

/// Reads a text of write_project_json. Keys that only the web editor understands are kept as JSON.
/// Errors: `bad_input` with the path of the key, `limit`.
Result<Project> read_project_json(std::string_view json);

/// Returns the text of project.json. The scene, the labels and the drawing's bytes are entries of
/// their own.
std::string write_project_json(const Project& project);

}  // namespace relievo
