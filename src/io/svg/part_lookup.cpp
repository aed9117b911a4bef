#include "io/svg/part_lookup.h"

namespace relievo {

int enclosing_part(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts, int group) {
  for (; group >= 0; group = drawing.groups[group].parent) {
    for (size_t k = 0; k < parts.size(); ++k) {
      if (parts[k].group == group) return static_cast<int>(k);
    }
  }
  return -1;
}

Result<int> part_named(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                       const std::string& name, int otherwise, const std::string& where) {
  if (name.empty()) return otherwise;
  for (size_t k = 0; k < parts.size(); ++k) {
    const SvgGroup& group = drawing.groups[parts[k].group];
    if (name == parts[k].part.id || name == group.id || name == group.label)
      return static_cast<int>(k);
  }
  return Error{ErrorCode::bad_input, "there is no part named \"" + name + "\"", where};
}

}  // namespace relievo
