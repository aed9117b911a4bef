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

/// A parsed file. Entities of a document type are never expanded and nothing is ever loaded from
/// elsewhere.
struct SvgDocument {
  pugi::xml_document xml;
  pugi::xml_node root;                                  ///< the outermost <svg>
  std::unordered_map<std::string, pugi::xml_node> ids;  ///< first element of each id
  std::vector<std::string> warnings;
};

/// Parses the bytes. Fails with limit where the file, its nesting or the number of its elements
/// is over the options' limits (checked before memory is spent), with bad_input where it is not
/// XML or not SVG.
Result<std::unique_ptr<SvgDocument>> parse_svg_document(std::string_view bytes,
                                                        const SvgOptions& options);

/// The element that href or xlink:href names, or an empty node.
pugi::xml_node referenced_element(const SvgDocument& document, const pugi::xml_node& element);

}  // namespace relievo
