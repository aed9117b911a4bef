#pragma once

#include <string>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// A layer of a document to be written.
struct PsdPicture {
  std::string name;  ///< UTF-8
  const Image8* rgba = nullptr;
  int left = 0, top = 0;  ///< px of the canvas, which holds the whole layer
  bool hidden = false;
};

/// Encodes a Photoshop document of 8 bits in RGB with layers from back to front, packed by
/// PackBits, and the flattened picture of the visible ones. Each layer is cut to its pixels that
/// are not transparent. Errors: `limit` for sides above 30,000 px, the format's own. O(pixels).
Result<Bytes> encode_psd(const std::vector<PsdPicture>& layers, int width, int height);

/// Encodes the parts of a drawing as layers to paint on (see paint_layers), each named `part:` and
/// its id, so that further layers become texture. The drawing itself lies behind them, hidden.
/// `rgba` covers the canvas. Errors: as encode_psd. O(pixels of all parts).
Result<Bytes> encode_part_layers(const Scene& scene, const Drawing& drawing);

}  // namespace relievo
