#pragma once

#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// A page that shows the model in any browser with WebGL and needs nothing else, neither a network
/// nor a server: turned by dragging, nearer and farther by the wheel. The drawing (may be null) is
/// its texture. The same input gives the same bytes. Errors: as check_exportable.
Result<Bytes> encode_html(const Model& model, const Drawing* drawing, const std::string& title);

}  // namespace relievo
