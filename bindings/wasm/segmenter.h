#pragma once

#include <emscripten/val.h>

#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "understanding/areas/basins.h"
#include "understanding/perception/network.h"

namespace relievo::wasm {

/// A flat drawing under scribbles. Keeps the results that depend on the drawing alone, so that a
/// changed stroke costs little. In all calls, `project` is the text of a project.json with the last
/// segmentation and the current strokes and corrections, and `last` is the labels.png of the last
/// segmentation, or empty. Every call returns a plain object, or {error} if it fails (see failure).
class Segmenter {
 public:
  /// Sets the drawing, a PNG file. `network` is the file of decode_network. Returns {}.
  emscripten::val open_png(const emscripten::val& file, const emscripten::val& network);

  /// Sets the drawing, pixels of 4 bytes each, straight alpha, in the same way. Returns {}.
  emscripten::val open_pixels(const emscripten::val& rgba, int width, int height,
                              const emscripten::val& network);

  /// Returns {labels, parts: [{label, id}], bridges: [{points, left, right}], notes}: the label of
  /// every pixel, and the closed gaps in lines with the labels beside them. See label_basins,
  /// relabel and Bridge.
  emscripten::val label(const std::string& project, const emscripten::val& last);

  /// Returns {project, scene, labels, warnings}, the results of strokes, corrections and edits: the
  /// texts of a project.json and a scene file, and a labels.png. `edited` is the text of the edited
  /// scene file. The text of a scene without parts is empty. See understand_drawing.
  emscripten::val propose(const std::string& project, const emscripten::val& last,
                          const std::string& edited);

 private:
  struct Labelled;

  emscripten::val open(Image8 rgba, const emscripten::val& network);
  Result<Labelled> read(const std::string& project, const emscripten::val& last);
  Status remember(const emscripten::val& last);

  understanding::Network network_;
  Drawing drawing_;
  understanding::Basins basins_;
  Bytes last_file_;
  Image16 last_labels_;  ///< of last_file_
};

/// Checks the text of a project.json and its labels.png. Returns {} if they are valid.
emscripten::val check_segmentation(const std::string& project, const emscripten::val& labels);

}  // namespace relievo::wasm
