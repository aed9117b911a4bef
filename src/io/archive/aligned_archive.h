#pragma once

#include <vector>

#include "io/archive/archive.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// Packs a zip archive of the entries in their order, stored, with the bytes of each at a multiple
/// of
/// 64. Error: `limit` above 4 GB.
Result<Bytes> pack_aligned(const std::vector<ArchiveEntry>& entries);

}  // namespace relievo
