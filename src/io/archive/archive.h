#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "relievo/bytes.h"

namespace relievo {

struct ArchiveEntry {
  std::string name;  ///< path inside the archive, segments separated by '/'
  Bytes bytes;
};

/// Returns the entry with this name, or null.
inline const ArchiveEntry* find_entry(const std::vector<ArchiveEntry>& entries,
                                      const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ArchiveEntry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace relievo
