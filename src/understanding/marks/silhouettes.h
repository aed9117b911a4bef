#pragma once

#include <string>
#include <vector>

#include "understanding/marks/layered_drawing.h"

namespace relievo::understanding {

/// Marks that share one silhouette: a fill and its dark twin behind it, the line around it, or the
/// shadings over all of it.
struct Silhouette {
  std::string name;       ///< of its first mark; may be empty
  int group = -1;         ///< of its first mark
  Color color;            ///< of its topmost fill
  Region region;          ///< all that its marks cover
  bool outlined = false;  ///< a line of another colour runs along its outline
};

/// The opaque content of a drawing.
struct SilhouetteList {
  std::vector<Silhouette> silhouettes;  ///< in paint order of their first marks
  Region covered;                       ///< all marks together, lines included
  Region ink;                           ///< lines, shades and highlights
  Region left_out;                      ///< the marks that the notes are on
  double diagonal = 0;                  ///< of the box around `covered`, px
  std::vector<std::string> notes;       ///< on marks that are left out, a sentence each
};

/// Groups the marks, in paint order, into silhouettes by their roles (see MarkRole). Ink and shades
/// are covered but no silhouettes; cast shadows, motion lines and backgrounds are left out.
SilhouetteList group_silhouettes(std::vector<Mark> marks, const Box2& canvas);

}  // namespace relievo::understanding
