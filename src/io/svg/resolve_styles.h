#pragma once

#include "io/svg/stylesheet.h"
#include "io/svg/svg_document.h"
#include "relievo/result.h"

namespace relievo {

/// Writes into the style attribute of each element what the sheet and this attribute declare for
/// it, and replaces var(--name, fallback) there and in other attributes by the value of the custom
/// property. What a <use> shows is copied where it depends on custom properties, which the <use>
/// inherits to it. The document's sheets become needless. Errors: `limit` where the rules or values
/// take too much work or room.
Status resolve_styles(SvgDocument& document, const Stylesheet& sheet, const SvgOptions& options);

}  // namespace relievo
