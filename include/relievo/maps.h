#pragma once

#include <cstdint>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Height, normal and part per pixel of the front view, by the order of parts (not by depth).
struct ReliefMaps {
  ImageF height;        ///< px of the canvas towards the viewer; NaN on the background
  ImageF normal;        ///< 3 channels, unit, X right, Y up, Z viewer; (0,0,1) on the background
  Image<int32_t> part;  ///< index of the visible part, -1 on the background
};

/// Normals as an 8-bit RGB PNG: round(127.5 n + 127.5), with n = (0, 0, 1) written as
/// (128, 128, 255), the background's colour too. Green points up (OpenGL, glTF, Blender, Godot,
/// Unity), or down (DirectX, Unreal).
Result<Bytes> encode_normal_map(const ReliefMaps& maps, bool green_down = false);

/// Heights as a 16-bit grey PNG, near = white: 0 is background and 1 to 65535 run linearly from the
/// lowest to the highest height (all 65535 where these are the same). The file's texts
/// "height_scale" and "height_offset" give back px: height = height_offset + height_scale * value.
Result<Bytes> encode_depth_map(const ReliefMaps& maps);

/// Visible parts as a 16-bit grey PNG: 0 is background, k + 1 is part k (back to front).
/// Errors: `limit` above 65535 parts.
Result<Bytes> encode_part_map(const ReliefMaps& maps);

}  // namespace relievo
