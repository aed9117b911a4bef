#pragma once

#include <string>
#include <vector>

#include "relievo/bytes.h"

namespace relievo {

struct ArchiveEntry {
  std::string name;  ///< path inside the archive, segments separated by '/'
  Bytes bytes;
};

/// The entry with a name, or null.
const ArchiveEntry* find_entry(const std::vector<ArchiveEntry>& entries, const std::string& name);

}  // namespace relievo
