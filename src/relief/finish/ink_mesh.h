#pragma once

#include "relief/finish/find_ink.h"
#include "relief/finish/ink_shell.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Makes lines of the ink that draw_in has left out of a surface. A ribbon fills each contour as it
/// is drawn: it begins at the drawn-in outline and faces the viewer, at the outline's height or
/// just above what lies behind. A shell, the surface once more, pushed out by the width of its ink
/// and turned inside out, draws the contour of other views. Their colours are added below the
/// picture, and texture coordinates of the model follow. `inked`: the drawing with its ink, three
/// channels. `width`: factor by which lines are wider than drawn. Precondition: there are lines.
/// O(n log n) for n triangles.
void add_ink(const ContourInk& ink, const Image8& inked, double width, Model& model,
             Image8& picture);

/// The same for a solid, which is drawn in first. Ribbons lie around `surface`. The shell goes
/// around the solid, whose last parts may have no ink.
void add_ink(const ContourInk& ink, const Image8& inked, double width, Model surface,
             const SolidPlace& place, Model& solid, Image8& picture);

}  // namespace relievo::relief
