#pragma once

#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Returns a page that shows the model in any browser with WebGL, without a network or server.
/// Dragging turns it, the wheel zooms. The drawing (may be null) is its texture. The same input
/// gives the same bytes. Errors: as check_exportable.
Result<Bytes> encode_html(const Model& model, const Drawing* drawing, const std::string& title);

}  // namespace relievo
