#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/svg/svg_options.h"
#include "relievo/result.h"

namespace relievo {

/// The value of a data-relievo attribute, which holds for an element and all below it.
enum class SvgMark {
  none,
  part,     ///< one part
  texture,  ///< painted, but no part
  ignore,   ///< neither
  join,     ///< a join, not painted
  cue,      ///< a cue, not painted
};

/// A parsed file. No other file is ever read. Sheets, custom properties, entities and transforms of
/// CSS are resolved: all that holds for an element is in its style attribute, which wins, and its
/// other attributes.
struct SvgDocument {
  pugi::xml_document xml;
  pugi::xml_node root;                                  ///< the outermost <svg>
  std::unordered_map<std::string, pugi::xml_node> ids;  ///< first element of each id, below it
  std::vector<std::string> warnings;
};

/// Parses the bytes. Errors: `limit` where the file, its nesting or the number of its elements
/// exceeds the options' limits (checked before memory is taken), `bad_input` where it is not XML or
/// not SVG.
Result<std::unique_ptr<SvgDocument>> parse_svg_document(std::string_view bytes,
                                                        const SvgOptions& options);

/// Returns the element that href or xlink:href names, or an empty node.
pugi::xml_node referenced_element(const SvgDocument& document, const pugi::xml_node& element);

/// Returns the element of this id if it has this local name, or an empty node.
pugi::xml_node named_element(const SvgDocument& document, const std::string& id,
                             std::string_view name);

/// Returns the element's mark; none for an unknown one.
SvgMark svg_mark(const pugi::xml_node& element);

/// Returns whether the element has an attribute for parts alone: data-c, data-d, data-flat,
/// data-lean or data-relation.
bool has_part_values(const pugi::xml_node& element);

/// Returns whether the element has a mark or an attribute for parts, joins or cues.
bool has_annotation(const pugi::xml_node& element);

/// Returns the element's inkscape:label or id; may be empty.
std::string name_of(const pugi::xml_node& element);

/// Returns whether a class of the element begins with "join" ("join-left").
bool has_join_class(const pugi::xml_node& element);

/// Returns whether a class of the element is "cue".
bool has_cue_class(const pugi::xml_node& element);

/// Returns whether elements of this name draw their children.
bool is_container(std::string_view local_name);

/// Returns whether a <switch> may choose the child: it is drawn, needs no extension, and is in
/// English or in no stated language.
bool switch_allows(const pugi::xml_node& child);

/// Returns whether the filter of this id ends in a blur, unlike that of a drop shadow.
bool is_blur(const SvgDocument& document, const std::string& filter);

}  // namespace relievo
