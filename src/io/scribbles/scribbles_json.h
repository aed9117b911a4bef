#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/scribbles/read_scribbles.h"
#include "relievo/result.h"
#include "understanding/labels/scribbles.h"

namespace relievo {

/// A scribble file, version 1: {"format": "relievo-scribbles", "version": 1, "parts": [id, ...],
/// "strokes": [{"kind": "soft" | "hard" | "outside" | "hole", "part": id, "width": px, "points":
/// [[x, y], ...]}, ...]} in drawing px. `part` belongs to soft and hard strokes only. "complete":
/// false leaves what no stroke touches as it is proposed. Errors:
/// `bad_input` with the place in `where`, `limit`.
Result<understanding::Scribbles> read_scribbles(std::string_view json,
                                                const ScribbleLimits& limits = {});

/// A stroke as these files have it.
nlohmann::ordered_json stroke_json(const understanding::Scribble& stroke,
                                   const understanding::Scribbles& scribbles);

}  // namespace relievo
