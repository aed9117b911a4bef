#pragma once

#include <string>
#include <vector>

#include "apps/cli/segment_project.h"
#include "kernel/base/result.h"

namespace relievo::cli {

/// Fills the labels of `input` from its drawing: with the strokes of the file `scribbles` (a
/// scribble file or picture), or those it already has where that is empty. Parts that strokes name
/// keep their names unless a correction says otherwise. Returns what a person should know.
Result<std::vector<std::string>> label_drawing(const std::string& scribbles, SegmentInput& input);

}  // namespace relievo::cli
