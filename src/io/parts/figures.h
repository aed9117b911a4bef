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
  bool blurred = false;   ///< its edge is not sharp
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
  std::vector<Figure> figures;     ///< in paint order of their first marks
  Region covered;                  ///< all marks together, lines included
  Region ink;                      ///< lines, shades and highlights
  double diagonal = 0;             ///< of the box around `covered`, px
  std::vector<std::string> notes;  ///< on marks that are in nothing of this, a sentence each
};

/// Sorts the marks, in paint order, into figures by their roles (see find_roles): ink and shades
/// count as covered, cast shadows, motion lines and backgrounds are left out. `canvas` is the whole
/// of it.
FigureList group_figures(std::vector<Mark> marks, const Box2& canvas);

}  // namespace relievo
