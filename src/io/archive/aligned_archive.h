#pragma once

#include <vector>

#include "io/archive/archive.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// A zip archive of the entries in their order, stored, the bytes of each beginning at a multiple
/// of 64. Error: `limit` above 4 GB.
Result<Bytes> pack_aligned(const std::vector<ArchiveEntry>& entries);

}  // namespace relievo
