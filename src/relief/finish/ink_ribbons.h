#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/image/image_size.h"
#include "kernel/image/pixel_box.h"
#include "relief/finish/find_ink.h"
#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// What lies behind the silhouette of a surface.
enum class Behind {
  nothing,  ///< ribbons hang in the air, at the height of the outline
  solid,    ///< its own back: the silhouette gets no ribbons
  plate,    ///< a plate that ribbons lie on
};

/// A strip that fills a stretch of a contour and faces the viewer.
struct InkRibbon {
  std::vector<std::array<Point3, 2>> rungs;  ///< canvas px: from the outline outwards
  PixelBox box;                              ///< the pixels of the drawing on it
};

/// Makes the ribbons of contours around a surface that was drawn in: at the height of its outline,
/// or just above the parts that lie behind it. `plate`: its height. They are cut into stretches
/// whose boxes hold few other pixels. `drawing`: its size. O(pixels of a small raster + points).
std::vector<InkRibbon> make_ribbons(const ContourInk& ink, const Model& surface, ImageSize drawing,
                                    Behind behind, double plate = 0);

}  // namespace relievo::relief
