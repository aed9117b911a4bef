#pragma once

#include <string>
#include <vector>

#include "io/svg/svg_drawing.h"

namespace relievo {

/// Shapes that share one silhouette (a dark twin behind a fill, a fill and the line drawn around
/// it, shadings over all of it) taken as one.
struct Figure {
  std::string name;       ///< of its first shape, or of that one's group; may be empty
  int group = -1;         ///< innermost group of its first shape
  SvgColor color;         ///< of its topmost fill
  Region region;          ///< all that its shapes cover
  bool outlined = false;  ///< a line of another colour runs along its outline
};

/// The opaque content of a drawing.
struct FigureList {
  std::vector<Figure> figures;  ///< in paint order of their first shapes
  Region covered;               ///< all opaque shapes together, thin lines included
  double diagonal = 0;          ///< of the box around `covered`, px
};

/// Sorts the shapes whose alpha is at least one half into figures. Lines (strokes without a fill,
/// and fills as thin as lines) count only as covered; a background over the whole canvas, joins
/// and what is marked as texture or to be ignored do not count at all. Where nothing is that
/// opaque, whatever can be seen is taken.
FigureList find_figures(const SvgDrawing& drawing);

/// What an element is marked as by itself or the nearest marked group around it.
SvgMark inherited_mark(const SvgDrawing& drawing, int group);

/// A name for what lies in the group: the nearest one given; may be empty.
std::string inherited_name(const SvgDrawing& drawing, int group);

}  // namespace relievo
