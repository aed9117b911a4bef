#pragma once

#include <cstdint>
#include <vector>

#include "kernel/image/image_size.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// What a part looks like where others lie in front of it: a piece of the shrunk drawing.
struct HiddenPatch {
  int part = 0;
  int x = 0;   ///< of its left column in the shrunk drawing
  int y = 0;   ///< of its top row there
  Image8 rgb;  ///< its border is at least a pixel away from what is hidden
};

struct HiddenPatches {
  ImageSize drawing;                 ///< the shrunk one
  std::vector<HiddenPatch> patches;  ///< by part
};

/// Paints what is hidden of each part smoothly on from what is seen of it, a little away from its
/// outline, where ink is. None where the drawing is empty or nothing is hidden, and of parts of
/// which nothing is seen. The drawing is shrunk to 512 px at most: what nobody drew has no
/// detail. Linear in its pixels, in the boxes of the parts and in triangles.
HiddenPatches hidden_patches(const Model& model, const Drawing& drawing);

/// The colours of patches at the vertices of what is hidden, three bytes each, white at others.
/// Linear in vertices.
std::vector<uint8_t> hidden_colours(const Model& model, const HiddenPatches& patches);

}  // namespace relievo::relief
