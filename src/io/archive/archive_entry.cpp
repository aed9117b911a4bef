#include <algorithm>

#include "io/archive/archive.h"

namespace relievo {

const ArchiveEntry* find_entry(const std::vector<ArchiveEntry>& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ArchiveEntry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace relievo
