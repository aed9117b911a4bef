#pragma once

#include <array>
#include <vector>

#include "kernel/image/image_size.h"
#include "kernel/image/pixel_box.h"
#include "relief/finish/find_ink.h"
#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// A strip that fills a stretch of a contour and faces the viewer.
struct InkRibbon {
  std::vector<std::array<Point3, 2>> rungs;  ///< canvas px: from the outline outwards
  PixelBox box;                              ///< the pixels of the drawing on it
};

/// Makes the ribbons of contours around a surface that was drawn in: at the height of its outline,
/// or just above the parts that lie behind it. `over_nothing`: whether outlines with nothing behind
/// get ribbons too. They are cut into stretches whose boxes hold few other pixels. `drawing`: its
/// size. O(pixels of a small raster + points).
std::vector<InkRibbon> make_ribbons(const ContourInk& ink, const Model& surface, ImageSize drawing,
                                    bool over_nothing);

}  // namespace relievo::relief
