#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/files/bytes.h"
#include "kernel/image/image.h"
#include "relief/completion/completion.h"
#include "relief/corrections/corrections.h"
#include "relief/drawing/scribbles.h"
#include "relief/scene/scene.h"
#include "relief/stacking/stacking.h"

namespace relievo {

/// The artist's own file.
struct ProjectDrawing {
  std::string name;            ///< file name without folders
  std::string kind = "image";  ///< "image" or "svg"
  std::string mime;            ///< "image/png", "image/jpeg" or "image/svg+xml"
  Bytes bytes;                 ///< untouched
};

/// How a part came to be.
struct PartRecord {
  PartLabel label = 0;
  std::string id;
  CompletionKind completion = CompletionKind::whole;
};

/// A join and how sure it is; its line is in the scene.
struct JoinRecord {
  PartLabel upper = 0;
  PartLabel lower = 0;
  double confidence = 0;
};

/// How a flat drawing was understood, and what the user said about it.
struct SegmentationRecord {
  Image16 labels;  ///< a pixel's part, 0 is background
  Scribbles scribbles;
  Corrections corrections;
  std::vector<PartRecord> parts;  ///< back to front
  std::vector<OrderArrow> order;  ///< between labels
  std::vector<JoinRecord> joins;
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

}  // namespace relievo
