#pragma once

#include "relievo/bytes.h"
#include "relievo/export.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Encodes the model as a 3MF file (see threemf_entries).
Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing,
                         const ExportOptions& options = {});

}  // namespace relievo
