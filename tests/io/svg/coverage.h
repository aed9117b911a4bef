#pragma once

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"
#include "relievo/scene.h"

namespace relievo {

/// 255 where the pixel's centre lies in some part, 0 elsewhere; the canvas is stretched over
/// width x height pixels. O(edges * rows they cross).
Image8 silhouette_mask(const Scene& scene, int width, int height);

/// How well the parts together cover what is drawn: the intersection over the union of their
/// silhouette and the pixels of the drawing with an alpha of at least one half. 1 where both are
/// empty.
double silhouette_agreement(const Scene& scene, const Drawing& drawing);

}  // namespace relievo
