#include "io/svg/svg_reading.h"

#include <algorithm>

namespace relievo {

void Reading::warn(const std::string& text) {
  auto& list = drawing.warnings;
  if (std::find(list.begin(), list.end(), text) == list.end() && list.size() < 100)
    list.push_back(text);
}

void Reading::fail(const std::string& what, size_t limit) {
  if (!error)
    error = Error{ErrorCode::limit, what + " (limit " + std::to_string(limit) + ")", "svg"};
}

bool Reading::begin_reference(const pugi::xml_node& target) {
  if (std::find(open_references.begin(), open_references.end(), target) != open_references.end()) {
    warn("an element that uses itself is ignored");
    return false;
  }
  open_references.push_back(target);
  return true;
}

std::string Reading::whereabouts(const pugi::xml_node& element,
                                 const InheritedState& around) const {
  const std::string name = name_of(element);
  const std::string layer = inherited_name(drawing, around.group);
  return std::string(local_name(element.name())) + (name.empty() ? "" : " " + name) +
         (layer.empty() ? "" : " in " + layer);
}

}  // namespace relievo
