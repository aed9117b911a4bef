#pragma once

#include <cstdint>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Height, normal and part of every pixel of the front view. The part in front is chosen by the
/// order of parts, not by depth.
struct ReliefMaps {
  ImageF height;        ///< px of the canvas towards the viewer; NaN on the background
  ImageF normal;        ///< 3 channels, unit, X right, Y up, Z viewer; (0,0,1) on the background
  Image<int32_t> part;  ///< index of the visible part, -1 on the background
};

/// Encodes normals as an 8-bit RGB PNG: round(127.5 n + 127.5); (0, 0, 1), the background's normal
/// too, becomes (128, 128, 255). Green points up (OpenGL, glTF, Blender, Godot, Unity), or down
/// (DirectX, Unreal).
Result<Bytes> encode_normal_map(const ReliefMaps& maps, bool green_down = false);

/// Encodes heights as a 16-bit grey PNG, near = white: 0 is background, and 1 to 65535 run linearly
/// from the lowest to the highest height (all 65535 if both are equal). The texts "height_scale"
/// and "height_offset" of the file convert values to px: height = height_offset + height_scale *
/// value.
Result<Bytes> encode_depth_map(const ReliefMaps& maps);

/// Encodes visible parts as a 16-bit grey PNG: 0 is background, k + 1 is part k (back to front).
/// Errors: `limit` above 65535 parts.
Result<Bytes> encode_part_map(const ReliefMaps& maps);

}  // namespace relievo
