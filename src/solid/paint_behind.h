#pragma once

#include "relief/surface/visible_sheet.h"
#include "relievo/image.h"

namespace relievo {

/// Paints the back of a figure as it is seen through the front: at every pixel of the drawing the
/// part that is rearmost there. With the front's paint F, the harmonic paint S grown from it at the
/// silhouette, the grain G of F off its marks, such as eyes and buttons, and a weight w that falls
/// from 1 at the silhouette to 0, it is
///   w F + (1 - w) (S + G),
/// so that front and back meet without a step. RGBA, of the drawing's size. Linear in pixels and in
/// the boxes of rear parts. Precondition: there is a drawing, and it is no pixel art.
Image8 paint_behind(const relief::VisibleSheet& sheet, const Drawing& drawing);

}  // namespace relievo
