#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/region.h"
#include "kernel/image/color.h"
#include "relievo/image.h"
#include "relievo/scene.h"

namespace relievo::understanding {

/// Colours at a smaller distance (see color_distance) look alike.
constexpr double color_contrast = 0.12;

/// The opaque area of one vector shape or one layer of pixels.
struct Mark {
  std::string name;  ///< may be empty
  int group = -1;    ///< innermost group that holds it, -1: none
  Region region;
  Color color;
  bool filled = true;     ///< false: a stroke without a fill
  double pen_width = 0;   ///< of a stroke without a fill, px
  bool outlined = false;  ///< a line of another colour runs along its outline
  bool blurred = false;   ///< its edge is soft
  bool blends = false;    ///< it changes the colours of what lies below: ink or paint, never a part
};

/// An SVG file that is safe to render: without joins, cues, elements marked
/// data-relievo="ignore", scripts, elements of other namespaces, and pictures other than embedded
/// PNG and JPEG files of at most 25 million pixels. Styles, custom properties and transforms are
/// resolved (see SvgDocument). Its root is as large as its canvas. In UTF-8.
struct PaintableSvg {
  std::string text;
  double width = 0;   ///< of the root, px
  double height = 0;  ///< likewise
};

/// A layered drawing (SVG, OpenRaster, Photoshop, a folder of pictures) as its file states it. Its
/// reader fills in everything but `proposed` and `line_art`; make_parts completes it.
struct LayeredDrawing {
  Scene scene;                  ///< canvas, and declared parts with joins, relations and cues
  std::vector<Palette> colors;  ///< [scene.parts]; palettes of pixel layers have one colour
  std::vector<Mark> marks;      ///< in paint order, where the file declares no parts
  /// The marks of each Inkscape layer, where the scene's parts are the layers but the file does not
  /// declare them as parts: a layer may hold several parts.
  std::vector<std::vector<Mark>> layers;
  Region left_out;  ///< background, shadows and motion lines that make_parts left out and named
  std::vector<Point2> anchors;  ///< ends of the curves of filled paths, canvas px
  Drawing picture;              ///< of layers of pixels, as large as the canvas
  PaintableSvg paintable;       ///< of a vector drawing
  /// The text of `paintable` where `layers` are no parts: with the lines that would join them.
  std::string text_with_lines;
  bool flat = false;                  ///< the layers are no parts: these come from segmentation
  bool proposed = false;              ///< make_parts proposed the parts
  bool line_art = false;              ///< it did, and the marks are lines that enclose the parts
  std::vector<std::string> warnings;  ///< a sentence each
};

}  // namespace relievo::understanding
