#pragma once

#include <string_view>

#include "relief/drawing/scribbles.h"
#include "relievo/result.h"

namespace relievo {

struct ScribbleLimits {
  size_t max_bytes = size_t{16} << 20;
  size_t max_strokes = 100'000;
  size_t max_points = 1'000'000;  ///< of all strokes together
};

/// A scribble file, version 1: {"format": "relievo-scribbles", "version": 1, "parts": [id, ...],
/// "strokes": [{"kind": "soft" | "hard" | "outside" | "hole", "part": id, "width": px, "points":
/// [[x, y], ...]}, ...]} in drawing px. `part` belongs to soft and hard strokes only. "complete":
/// false leaves what no stroke touches as it is proposed. Errors:
/// `bad_input` with the place in `where`, `limit`.
Result<Scribbles> read_scribbles(std::string_view json, const ScribbleLimits& limits = {});

}  // namespace relievo
