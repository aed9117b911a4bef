#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/svg/object_box.h"
#include "io/svg/svg_document.h"
#include "io/svg/svg_drawing.h"
#include "io/svg/svg_options.h"
#include "io/svg/svg_picture.h"
#include "io/svg/svg_style.h"
#include "io/svg/svg_values.h"

namespace relievo {

/// The state that an element inherits.
struct InheritedState {
  Affine2 to_canvas;
  SvgStyle style;
  LengthContext lengths;
  double opacity = 1;
  std::vector<int> clips;
  bool blurred = false;
  Backdrop backdrop;
  size_t isolated = 0;  ///< first shape with which those here can blend
  int group = -1;
  size_t depth = 0;
  bool in_clip = false;
};

/// The state of reading a document.
struct Reading {
  const SvgDocument& document;
  const SvgOptions& options;
  SvgDrawing drawing = {};
  std::vector<pugi::xml_node> open_references = {};
  std::map<size_t, SvgPicture> pictures = {};  ///< by the hash of their elements
  int64_t picture_pixels = 0;                  ///< of all pictures together
  BoxSearch boxes = {document};
  size_t elements = 0;
  size_t points = 0;
  double tangle = 0;
  std::optional<Error> error = {};

  void warn(const std::string& text);

  /// Ends the reading with an error, unless it has one.
  void fail(const std::string& what, size_t limit);

  /// Opens a reference; returns false where it is open already, since it leads back to itself.
  bool begin_reference(const pugi::xml_node& target);

  /// Returns the name of an element for warnings.
  std::string whereabouts(const pugi::xml_node& element, const InheritedState& around) const;
};

}  // namespace relievo
