#pragma once

#include <string>
#include <vector>

#include "io/parts/figures.h"
#include "io/svg/svg_drawing.h"

namespace relievo {

/// Paint with a lower alpha is not seen.
constexpr double faint_alpha = 0.02;

/// The shapes whose alpha is at least one half, or, where nothing is that opaque, whatever can be
/// seen. Joins, cues and what is marked as texture or to be ignored are left out.
std::vector<Mark> opaque_marks(const SvgDrawing& drawing);

/// What an element is marked as by itself or the nearest marked group around it.
SvgMark inherited_mark(const SvgDrawing& drawing, int group);

/// A name for what lies in the group: the nearest one given; may be empty.
std::string inherited_name(const SvgDrawing& drawing, int group);

}  // namespace relievo
