#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

struct ArchiveEntry {
  std::string name;  ///< path inside the archive, segments separated by '/'
  Bytes bytes;
};

/// The entry with a name, or null.
inline const ArchiveEntry* find_entry(const std::vector<ArchiveEntry>& entries,
                                      const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ArchiveEntry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

/// What an archive may ask for; checked from its directory, before anything is unpacked.
struct ArchiveLimits {
  uint64_t max_entries = 2000;
  uint64_t max_bytes = uint64_t{1} << 30;  ///< of all entries together, unpacked
  uint64_t max_ratio = 1000;               ///< of an entry's size unpacked and packed
};

/// Whether `bytes` begin as a zip archive does.
bool is_archive(ByteView bytes);

/// The files of a zip archive in the order of its directory; folders are passed over. Errors:
/// bad_input (damaged, encrypted, a name twice or one that leads out of the archive), limit.
Result<std::vector<ArchiveEntry>> unpack_archive(ByteView bytes, const ArchiveLimits& limits = {});

/// A zip archive of the entries, in their order. Entries that are pictures or named "mimetype" are
/// stored, others deflated. The same entries give the same bytes: all carry the first of January
/// 1980. Errors: `internal` where the library fails, `limit` where there is no memory.
Result<Bytes> pack_archive(const std::vector<ArchiveEntry>& entries);

/// A zip archive of the entries in their order, stored, the bytes of each beginning at a multiple
/// of 64. Error: `limit` above 4 GB.
Result<Bytes> pack_aligned(const std::vector<ArchiveEntry>& entries);

}  // namespace relievo
