#pragma once

#include "relievo/bytes.h"
#include "relievo/export.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// The same as the bytes of a file.
Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing,
                         const ExportOptions& options = {});

}  // namespace relievo
