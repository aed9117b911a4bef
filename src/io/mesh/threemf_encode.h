#pragma once

#include <vector>

#include "io/archive/archive.h"
#include "relievo/bytes.h"
#include "relievo/export.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Returns the model as the files of a 3MF package: mm, lying or standing as in an STL, one object
/// with shared vertices. With a drawing, its triangles have a texture (materials extension) and are
/// painted for several filaments, whose colours the package's description lists. Precondition: the
/// model is a closed manifold. Errors: as check_exportable; `internal` where it cannot be packed.
Result<std::vector<ArchiveEntry>> threemf_entries(const Model& model, const Drawing* drawing,
                                                  const ExportOptions& options = {});

/// Encodes the model as a 3MF file (see threemf_entries). The browser packs its entries itself.
Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing,
                         const ExportOptions& options = {});

}  // namespace relievo
