#pragma once

#include <cstddef>
#include <cstdint>

#include "io/image/image_limits.h"
#include "relief/finish/finish_model.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// Numbers of glTF 2.0 for the types of an accessor's components.
constexpr size_t component_u16 = 5123;
constexpr size_t component_u32 = 5125;
constexpr size_t component_f32 = 5126;

struct GlbLimits {
  int64_t max_vertices = 20'000'000;
  int64_t max_triangles = 40'000'000;
  int64_t max_json_bytes = int64_t{64} << 20;
  ImageLimits image;
};

/// Reads a GLB file of the kind that encode_glb writes: untransformed nodes with indexed triangles
/// that have POSITION, NORMAL and TEXCOORD_0, an embedded base colour image or none. Every node's
/// mesh becomes a part. Without the extras that lead back to canvas px, the model is scaled to
/// 1000 px and its bounding box is the canvas. Errors: `bad_input` where the file is damaged or of
/// another kind (never undefined behaviour, whatever the bytes), `limit`.
Result<relief::DrawnModel> decode_glb(ByteView bytes, const GlbLimits& limits = {});

}  // namespace relievo
