#pragma once

#include <emscripten/val.h>

#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "understanding/areas/basins.h"

namespace relievo::wasm {

/// A flat drawing on which a person scribbles. Keeps what only the drawing decides, so that a
/// changed stroke costs little. `project` is the text of a project.json with the segmentation as it
/// was before, but for its strokes and corrections; `last` the labels.png from then, empty where
/// there is none. Every call returns a plain object, {error} where it failed (see failure).
class Segmenter {
 public:
  /// {}: takes a PNG file as the drawing.
  emscripten::val open_png(const emscripten::val& file);

  /// {}: takes pixels, 4 bytes each, straight alpha.
  emscripten::val open_pixels(const emscripten::val& rgba, int width, int height);

  /// {labels, parts: [{label, id}], bridges: [{points, left, right}], notes}: the label of every
  /// pixel under the strokes, and the gaps in lines that are closed, with the labels beside them.
  /// See label_basins, relabel and Bridge.
  emscripten::val label(const std::string& project, const emscripten::val& last);

  /// {project, scene, labels, warnings}: all that follows from strokes, corrections and what was
  /// done to the scene, as texts of a project.json and a scene file and as a labels.png. `edited`
  /// is the text of the scene file as it is now. Texts of scenes without parts are empty. See
  /// understand_drawing.
  emscripten::val propose(const std::string& project, const emscripten::val& last,
                          const std::string& edited);

 private:
  struct Labelled;

  emscripten::val open(Image8 rgba);
  Result<Labelled> read(const std::string& project, const emscripten::val& last);
  Status remember(const emscripten::val& last);

  Drawing drawing_;
  understanding::Basins basins_;
  Bytes last_file_;
  Image16 last_labels_;  ///< of last_file_
};

/// {}, or why the text of a project.json or its labels.png cannot be used.
emscripten::val check_segmentation(const std::string& project, const emscripten::val& labels);

}  // namespace relievo::wasm
