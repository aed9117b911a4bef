#pragma once

#include <string>
#include <vector>

#include "io/parts/color.h"
#include "io/parts/region.h"

namespace relievo {

/// Colours nearer than this look alike.
constexpr double color_contrast = 0.12;

/// One shape or layer as far as it is opaque.
struct Mark {
  std::string name;  ///< may be empty
  int group = -1;    ///< innermost group it belongs to, -1: none
  Region region;
  Color color;
  bool filled = true;     ///< false: a stroke alone
  double pen_width = 0;   ///< of a stroke alone, px
  bool outlined = false;  ///< a line of another colour runs along its outline
};

/// Marks that share one silhouette (a dark twin behind a fill, a fill and the line drawn around
/// it, shadings over all of it) taken as one.
struct Figure {
  std::string name;       ///< of its first mark; may be empty
  int group = -1;         ///< of its first mark
  Color color;            ///< of its topmost fill
  Region region;          ///< all that its marks cover
  bool outlined = false;  ///< a line of another colour runs along its outline
};

/// The opaque content of a drawing.
struct FigureList {
  std::vector<Figure> figures;  ///< in paint order of their first marks
  Region covered;               ///< all marks together, thin lines included
  double diagonal = 0;          ///< of the box around `covered`, px
};

/// Sorts the marks into figures. Lines (strokes without a fill, and fills as thin as lines) count
/// only as covered.
FigureList group_figures(std::vector<Mark> marks);

}  // namespace relievo
