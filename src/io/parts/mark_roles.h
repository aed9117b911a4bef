#pragma once

#include <vector>

#include "io/parts/figures.h"

namespace relievo {

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

}  // namespace relievo
