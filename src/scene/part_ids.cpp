#include "scene/part_ids.h"

#include <set>
#include <string>

#include "kernel/base/text_rules.h"

namespace relievo {

void make_ids_unique(std::vector<Part>& parts) {
  std::set<std::string> taken;
  for (size_t k = 0; k < parts.size(); ++k) {
    const std::string base = parts[k].id.empty() ? "part-" + std::to_string(k + 1) : parts[k].id;
    parts[k].id = free_name(base, [&](const std::string& id) { return taken.count(id) > 0; });
    taken.insert(parts[k].id);
  }
}

}  // namespace relievo
