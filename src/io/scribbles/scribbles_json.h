#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/scene/json_reader.h"
#include "relievo/result.h"
#include "understanding/labels/scribbles.h"

namespace relievo {

/// Reads a scribble file, version 1: {"format": "relievo-scribbles", "version": 1, "parts": [id,
/// ...], "strokes": [{"kind": "soft" | "hard" | "outside" | "hole", "part": id, "width": px,
/// "points": [[x, y], ...]}, ...]} in drawing px. Only soft and hard strokes have a "part".
/// "complete": false, where given, leaves the areas without strokes as they are proposed; "count"
/// is the wanted number of parts. Coordinates and widths are less than a million px. Errors:
/// `bad_input` with the path of the key in `where`, `limit`.
Result<understanding::Scribbles> read_scribbles(std::string_view json,
                                                const JsonLimits& limits = {size_t{16} << 20});

/// Reads the object with "parts" and "strokes" that a project holds at `path`; its scribbles are
/// complete only where "complete" is true. Errors: as read_scribbles.
Result<understanding::Scribbles> scribbles_of(const nlohmann::json& json, const JsonPath& path);

/// Returns a stroke as these files hold it.
nlohmann::ordered_json stroke_json(const understanding::Scribble& stroke,
                                   const understanding::Scribbles& scribbles);

}  // namespace relievo
