#pragma once

#include <functional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/svg/stylesheet.h"
#include "io/svg/svg_document.h"

namespace relievo {

/// Returns the value of a property that an element's style attribute or else its attribute of this
/// name states; may be empty.
std::string stated_value(const pugi::xml_node& element, std::string_view name);

/// Sets an attribute, which is added where it is missing.
void set_attribute(pugi::xml_node node, const char* name, const std::string& value);

/// Writes the style attribute; an empty one goes.
void set_style(pugi::xml_node element, const std::vector<Declaration>& declarations);

/// Moves all that is in an element into a new group in it, and returns the group.
pugi::xml_node wrap_children(pugi::xml_node element);

/// Gives a copy of an element a new id, and those in it none, since the first element of an id
/// counts. Returns the number of elements.
size_t rename_copy(pugi::xml_node copy, SvgDocument& document);

/// Visits all elements below the root, each after those in it, with what its lengths refer to.
void visit_elements(const SvgDocument& document,
                    const std::function<void(pugi::xml_node, const LengthContext&)>& visit);

}  // namespace relievo
