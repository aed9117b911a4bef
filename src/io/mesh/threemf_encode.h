#pragma once

#include <vector>

#include "io/archive/archive_entry.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Which programs' way of painting triangles a file has: they do not read each other's.
enum class Slicer {
  prusa,  ///< PrusaSlicer and its kin, by attributes in a namespace of their own
  bambu,  ///< Bambu Studio and OrcaSlicer, by one that the format does not know
};

struct ThreemfOptions {
  double size_mm = 100;  ///< longest side
  int filaments = 4;     ///< at most so many colours are painted, in [1, 16]
  Slicer slicer = Slicer::prusa;
};

/// The model as the files of a 3MF package: mm, lying on z = 0 in the positive octant, one object
/// whose vertices at one place are one. With a drawing its triangles carry that as a texture
/// (materials extension), and are painted for several filaments, whose colours are listed in the
/// package's description. Precondition: the model is a closed manifold. Errors: as
/// check_exportable; `internal` where it cannot be packed.
Result<std::vector<ArchiveEntry>> threemf_entries(const Model& model, const Drawing* drawing,
                                                  const ThreemfOptions& options = {});

/// The same as the bytes of a file.
Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing,
                         const ThreemfOptions& options = {});

}  // namespace relievo
