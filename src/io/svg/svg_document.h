#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/svg/stylesheet.h"
#include "io/svg/svg_options.h"
#include "relievo/result.h"

namespace relievo {

/// What a data-relievo attribute says of an element and all below it.
enum class SvgMark {
  none,
  part,     ///< one part
  texture,  ///< painted, but no part
  ignore,   ///< neither
  join,     ///< a join, not painted
  cue,      ///< a cue, not painted
};

/// The annotations of one element, as written.
struct SvgAnnotation {
  SvgMark mark = SvgMark::none;
  std::string c;
  std::string d;
  std::string flat;
  std::string lean;
  std::string relation;
  std::string upper;
  std::string lower;
  std::string cue;    ///< kind
  std::string value;  ///< of a cue
  std::string part;   ///< likewise

  bool empty() const {
    return mark == SvgMark::none && !has_part_values() && upper.empty() && lower.empty() &&
           cue.empty();
  }

  /// Whether it sets what only a part has.
  bool has_part_values() const {
    return !c.empty() || !d.empty() || !flat.empty() || !lean.empty() || !relation.empty();
  }
};

/// A parsed file. Entities of a document type are never expanded and nothing is ever loaded from
/// elsewhere.
struct SvgDocument {
  pugi::xml_document xml;
  pugi::xml_node root;                                  ///< the outermost <svg>
  std::unordered_map<std::string, pugi::xml_node> ids;  ///< first element of each id, below it
  Stylesheet sheet;                                     ///< of all <style> elements
  std::vector<std::string> warnings;
};

/// Parses the bytes. Fails with limit where the file, its nesting or the number of its elements
/// is over the options' limits (checked before memory is spent), with bad_input where it is not
/// XML or not SVG.
Result<std::unique_ptr<SvgDocument>> parse_svg_document(std::string_view bytes,
                                                        const SvgOptions& options);

/// The element that href or xlink:href names, or an empty node.
pugi::xml_node referenced_element(const SvgDocument& document, const pugi::xml_node& element);

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
