#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "io/archive/archive.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// Packs a zip archive of the entries, in their order. Pictures and an entry named "mimetype" are
/// stored, others deflated. The same entries give the same bytes: all carry the first of January
/// 1980. Error: `internal` where the library fails.
Result<Bytes> pack_archive(const std::vector<ArchiveEntry>& entries);

/// Limits of an archive, checked from its directory before anything is unpacked.
struct ArchiveLimits {
  uint64_t max_entries = 2000;
  uint64_t max_bytes = uint64_t{1} << 30;  ///< of all entries together, unpacked
  uint64_t max_ratio = 1000;               ///< of an entry's unpacked to its packed size
};

/// Returns whether `bytes` begin like a zip archive.
bool is_archive(ByteView bytes);

/// Unpacks the files of a zip archive in the order of its directory, without folders: those with
/// one of the names, in an archive of any length, or all. Errors: `bad_input` (damaged, encrypted,
/// a repeated name or one that leads out of the archive), `limit`.
Result<std::vector<ArchiveEntry>> unpack_archive(ByteView bytes, const ArchiveLimits& limits = {},
                                                 const std::set<std::string>& names = {});

}  // namespace relievo
