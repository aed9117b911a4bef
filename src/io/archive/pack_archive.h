#pragma once

#include <vector>

#include "io/archive/archive.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// Packs a zip archive of the entries, in their order. Pictures and an entry named "mimetype" are
/// stored, others deflated. The same entries give the same bytes: all carry the first of January
/// 1980. Error: `internal` where the library fails.
Result<Bytes> pack_archive(const std::vector<ArchiveEntry>& entries);

}  // namespace relievo
