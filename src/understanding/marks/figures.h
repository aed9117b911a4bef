#pragma once

#include <string>
#include <vector>

#include "understanding/marks/layered_drawing.h"

namespace relievo::understanding {

/// Marks that share one silhouette: a fill and its dark twin behind it, the line around it, or the
/// shadings over all of it.
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
  std::vector<std::string> notes;  ///< on marks that are left out, a sentence each
};

/// Groups the marks, in paint order, into figures by their roles (see find_roles). Ink and shades
/// are covered but no figures; cast shadows, motion lines and backgrounds are left out.
FigureList group_figures(std::vector<Mark> marks, const Box2& canvas);

/// The use of a mark in a drawing.
enum class MarkRole {
  shape,       ///< a part, or paint on one
  ink,         ///< lines: an outline plate below or above the colours, strokes, hatching
  shade,       ///< a shade or highlight on what lies below it
  shadow,      ///< cast on the floor
  motion,      ///< lines that stand apart from everything
  background,  ///< behind all
};

/// Returns the roles of marks in paint order. Only shapes can become parts. The other roles are:
///  - background: a rectangle, the first mark or on other backgrounds, that reaches at least three
///    sides of the canvas, or all four where nothing else is drawn;
///  - shadow: flat, at the lower end, on background alone, and translucent, blurred or a dark
///    ellipse;
///  - ink: a stroke or fill as thin as a line; or dark, visible no wider than a thick pen, along or
///    inside fills, and not the twin of a fill;
///  - shade: translucent and mostly over earlier marks; or a crescent or stripe of the same hue
///    within them;
///  - motion: ink that is nowhere near a fill.
std::vector<MarkRole> find_roles(const std::vector<Mark>& marks, const Box2& canvas);

/// Returns whether the two regions differ by no more than a thin rim, in a drawing of this
/// diagonal.
bool same_silhouette(const Region& p, const Region& q, double diagonal);

}  // namespace relievo::understanding
