#pragma once

#include "relief/finish/find_ink.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// The contours that finish_sheet has taken off a drawing.
struct TakenInk {
  ContourInk contours;  ///< no lines if there are no contours, or they are not drawn as lines
  Image8 inked;         ///< the drawing with them, three channels
};

/// Finishes the drawing on the sheet of a solid, as finish_model does that on a surface: contours
/// stay in the paint or are taken off it. If they are to become lines they are returned, for
/// add_ink when the solid is there. Linear in pixels and triangles.
TakenInk finish_sheet(Ink ink, const Model& sheet, Drawing& drawing);

}  // namespace relievo::relief
