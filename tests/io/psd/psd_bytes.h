#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/image.h"

namespace relievo {

/// How the planes of a test's document are packed.
enum class PsdPacking : uint16_t { raw, pack_bits, zip, zip_differences };

/// A layer to be written: the end of a group, a group, or pixels.
struct PsdLayerSpec {
  std::string name;
  int x = 0;
  int y = 0;
  Image8 rgba;
  uint8_t opacity = 255;
  bool hidden = false;
  bool clipped = false;
  int divider = 0;  ///< 1: group, 3: end of a group
  std::string blend = "norm";
  Image8 mask;          ///< at (x, y); empty: none
  uint8_t outside = 0;  ///< of the mask
  bool effects = false;
  std::vector<std::pair<std::string, Bytes>> blocks = {};  ///< further ones, by their keys
};

struct PsdSpec {
  int width = 8;
  int height = 8;
  int depth = 8;
  int mode = 3;
  int version = 1;
  PsdPacking packing = PsdPacking::raw;
  std::vector<PsdLayerSpec> layers;  ///< back to front
  Image8 merged;                     ///< empty: black
  bool merged_alpha = false;         ///< the merged picture has transparency, its colours on white
};

Bytes psd_bytes(const PsdSpec& spec);

/// All pixels the same.
Image8 filled(int width, int height, const std::vector<uint8_t>& rgba);

}  // namespace relievo
