#pragma once

#include <string>
#include <string_view>

#include "io/svg/svg_drawing.h"

namespace relievo {

/// What the data- attributes of the element say.
SvgAnnotation annotation_of(const pugi::xml_node& element);

/// inkscape:label or id; may be empty.
std::string name_of(const pugi::xml_node& element);

/// Whether a class of the element is "join" or begins so ("join-left").
bool has_join_class(const pugi::xml_node& element);

/// Whether a class of the element is "cue".
bool has_cue_class(const pugi::xml_node& element);

/// Whether elements of this name draw their children.
bool is_container(std::string_view local_name);

/// Whether a <switch> may choose the child: it is drawn, needs no extension and speaks English or
/// no language at all.
bool switch_allows(const pugi::xml_node& child);

/// Whether the filter of this id ends in a blur; one whose blur is but a drop shadow does not.
bool is_blur(const SvgDocument& document, const std::string& filter);

}  // namespace relievo
