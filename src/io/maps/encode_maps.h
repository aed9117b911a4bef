#pragma once

#include "io/files/bytes.h"
#include "kernel/base/result.h"
#include "relief/model/relief_maps.h"

namespace relievo {

/// Which way the green channel of a normal map points: up (OpenGL, glTF, Blender, Godot, Unity)
/// or down (DirectX, Unreal).
enum class GreenAxis { up, down };

/// Normals as an 8-bit RGB PNG: round(127.5 n + 127.5), with n = (0, 0, 1) written as
/// (128, 128, 255), the background's colour too.
Result<Bytes> encode_normal_map(const ReliefMaps& maps, GreenAxis green = GreenAxis::up);

/// Heights as a 16-bit grey PNG, near = white: 0 is background and 1 to 65535 run linearly from the
/// lowest to the highest height (all 65535 where these are the same). The file's texts
/// "height_scale" and "height_offset" give back px: height = height_offset + height_scale * value.
Result<Bytes> encode_depth_map(const ReliefMaps& maps);

/// Visible parts as a 16-bit grey PNG: 0 is background, k + 1 is part k (back to front).
/// Errors: `limit` above 65535 parts.
Result<Bytes> encode_part_map(const ReliefMaps& maps);

}  // namespace relievo
