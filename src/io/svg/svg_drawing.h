#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/svg/svg_document.h"
#include "io/svg/svg_region.h"
#include "relievo/result.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// A <g>, or a single annotated shape as the group of itself.
struct SvgGroup {
  int parent = -1;
  pugi::xml_node element;
  SvgMark mark = SvgMark::none;
  bool layer = false;

  /// Returns the value of an attribute; empty where there is none.
  std::string value(const char* name) const { return element.attribute(name).value(); }
};

/// A range of shapes over which another one is blended, by multiply, screen and the like.
struct Backdrop {
  size_t begin = 0;
  size_t end = 0;
};

/// The picture that a shape shows.
struct ShownPicture {
  Region opaque;           ///< on the canvas
  bool outlined = false;   ///< a line of another colour runs along its outline
  bool has_holes = false;  ///< some of it is not opaque
};

/// One shape as it is painted, in canvas px.
struct SvgShape {
  std::string name;  ///< inkscape:label or id; may be empty
  pugi::xml_node element;
  int group = -1;  ///< innermost group, -1: none
  std::vector<Polyline> lines;
  std::vector<Point2> anchors;  ///< ends of its curves, where it is a path
  FillRule fill_rule = FillRule::nonzero;
  std::optional<Color> fill;    ///< representative; alpha is that of the paint, all groups included
  std::optional<Color> stroke;  ///< likewise
  StrokeShape pen;
  std::optional<Affine2> pen_frame;     ///< maps a space in which the pen is round to the canvas
  std::vector<int> clips;               ///< each cuts the shape
  std::optional<ShownPicture> picture;  ///< in place of a fill of one colour
  Backdrop backdrop;                    ///< empty where it is laid over all that is below
  bool blurred = false;                 ///< by a filter
  bool join = false;  ///< marked as a join by data-relievo or by a class named join
  bool cue = false;   ///< likewise as a cue

  /// Returns whether it annotates parts and is not painted.
  bool is_note() const { return join || cue; }
};

/// The vector content of a file, flattened. Shapes are in paint order; a group stands before those
/// inside it. Elements belong to the document, which must outlive the drawing.
struct SvgDrawing {
  double width = 0;      ///< canvas, px
  double height = 0;     ///< canvas, px
  double px_width = 0;   ///< viewport of the root before it is scaled to the canvas, px
  double px_height = 0;  ///< likewise
  std::vector<SvgShape> shapes;
  std::vector<SvgGroup> groups;
  std::vector<Region> clips;
  std::vector<std::string> warnings;

  Box2 canvas() const { return {{0, 0}, {width, height}}; }
};

/// Reads all shapes. A canvas without a stated size holds them all. A mask cuts like a clip path.
/// Texts, pictures other than embedded PNG and JPEG files, and shapes with points beyond 1e9 px are
/// left out, with a warning that names them and their layer. Errors: `limit`, `bad_input`.
Result<SvgDrawing> read_drawing(const SvgDocument& document, const SvgOptions& options);

/// Returns the area that the shape fills on the canvas, whatever its paint.
Region fill_of(const SvgShape& shape, const SvgDrawing& drawing);

/// Returns the area that its stroke covers on the canvas; empty where it has none.
Region stroke_of(const SvgShape& shape, const SvgDrawing& drawing);

/// Returns the area that is lighter than half where the shapes are painted on black, one over the
/// other: the area that a mask of them shows.
Region light_region(const std::vector<SvgShape>& shapes, const SvgDrawing& drawing);

/// Returns the area that is more than half opaque where the shapes are painted.
Region opaque_region(const std::vector<SvgShape>& shapes, const SvgDrawing& drawing);

/// Returns whether the shape is paint on what lies below: it is blended with it, or is a picture
/// without holes over it. What covers the whole canvas is paper, and nothing lies below on it.
bool is_paint(const SvgShape& shape, const SvgDrawing& drawing);

/// Paint with a lower alpha is invisible.
constexpr double faint_alpha = 0.02;

/// Returns the shapes (of `drawing`) whose alpha is at least one half, or, where no shape is that
/// opaque, all that can be seen. Joins, cues, paint, textures and ignored shapes are left out.
std::vector<understanding::Mark> opaque_marks(const SvgDrawing& drawing,
                                              const std::vector<const SvgShape*>& shapes);

/// Returns the mark of the group or the nearest marked group around it.
SvgMark inherited_mark(const SvgDrawing& drawing, int group);

/// Returns the label or id of the group or the nearest group around it that has one; may be empty.
std::string inherited_name(const SvgDrawing& drawing, int group);

}  // namespace relievo
