#pragma once

#include <cstdint>
#include <vector>

#include "kernel/image/image_size.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// The colours of a part behind others: a piece of the shrunk drawing.
struct HiddenPatch {
  int part = 0;
  int x = 0;   ///< of its left column in the shrunk drawing
  int y = 0;   ///< of its top row there
  Image8 rgb;  ///< its border is at least a pixel away from hidden triangles
};

struct HiddenPatches {
  ImageSize drawing;                 ///< of the shrunk drawing
  std::vector<HiddenPatch> patches;  ///< by part
};

/// Extends the seen colours of each part smoothly over its hidden triangles. Pixels near its
/// outline, which may be ink, do not count. There are no patches if the drawing is empty, and none
/// for parts without hidden or without seen triangles. The drawing is shrunk to 512 px at most,
/// since hidden areas have no detail; pixel art is shrunk to its
/// own size, and keeps its colours. Linear in its pixels, in the boxes of the parts and in
/// triangles.
HiddenPatches hidden_patches(const Model& model, const Drawing& drawing);

/// Returns a colour for each vertex, three bytes: that of its patch at vertices of hidden
/// triangles, white at others. Linear in vertices.
std::vector<uint8_t> hidden_colours(const Model& model, const HiddenPatches& patches);

/// Lays the patches below the drawing in its picture, four channels, and the hidden triangles on
/// them: texture coordinates become those of the picture, vertices between seen and hidden
/// triangles are doubled, and no triangle counts as hidden any more. Linear in pixels and
/// triangles.
void lay_patches(const HiddenPatches& found, Model& model, Image8& rgba);

}  // namespace relievo::relief
