#pragma once

#include <vector>

#include "io/archive/archive.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// A zip archive of the entries, in their order. Entries that are pictures or named "mimetype" are
/// stored, others deflated. The same entries give the same bytes: all carry the first of January
/// 1980. Errors: `internal` where the library fails, `limit` where there is no memory.
Result<Bytes> pack_archive(const std::vector<ArchiveEntry>& entries);

}  // namespace relievo
