#pragma once

#include "relief/surface/visible_sheet.h"
#include "relievo/image.h"

namespace relievo {

/// Paints the back of a figure as it is seen through the front: at every pixel of the drawing the
/// part that is rearmost there. Near the silhouette the paint is the front's, so that both meet
/// without a step; farther in it is grown harmonically from there, with the grain of the front's
/// paint but without its marks, such as eyes and buttons. Pixel art has the commonest colour of
/// each part. Linear in pixels times the share of rear parts' boxes.
Image8 paint_behind(const relief::VisibleSheet& sheet, const Drawing& drawing);

}  // namespace relievo
