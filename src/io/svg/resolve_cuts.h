#pragma once

#include "io/svg/svg_document.h"
#include "relievo/result.h"

namespace relievo {

/// Gives each element that is cut by a clip path or mask in units of its box a copy of it in user
/// units. Those of elements with text, whose box only a renderer knows, stay as they are. Errors:
/// `limit` where that takes too many elements, or boxes too much work.
Status resolve_cuts(SvgDocument& document, const SvgOptions& options);

}  // namespace relievo
