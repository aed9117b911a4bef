#pragma once

#include <string>
#include <vector>

#include "understanding/marks/layered_drawing.h"

namespace relievo::understanding {

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

/// What a mark is to the parts of a drawing.
enum class MarkRole {
  shape,       ///< a part, or paint on one, as the drawing as a whole decides
  ink,         ///< lines: an outline plate below or above the colours, strokes, hatching
  shade,       ///< a shade or highlight on what lies below it
  shadow,      ///< cast on the ground
  motion,      ///< lines that stand apart from everything
  background,  ///< behind all
};

/// The roles of marks in paint order; `canvas` is the whole of it. Paint with a role of its own is
/// never a part:
///  - background: the first mark, or one on others of this role, is a rectangle that ends at three
///    sides of the canvas at least, or at all four where nothing else is drawn;
///  - shadow: flat, at the lower end, half transparent or blurred or a dark ellipse, and lies on
///    nothing but background;
///  - ink: a stroke without a fill, or a fill, as thin as a line; or dark, seen no wider than a
///    thick pen, along or inside fills, and not the twin of one of them;
///  - shade: half transparent, and mostly over what was painted before; or a crescent or stripe
///    of the same hue within that;
///  - motion: ink of which nothing comes near a fill.
std::vector<MarkRole> find_roles(const std::vector<Mark>& marks, const Box2& canvas);

/// Whether the two differ by no more than a rim that is thin against both, in a drawing of this
/// diagonal.
bool same_silhouette(const Region& p, const Region& q, double diagonal);

}  // namespace relievo::understanding
