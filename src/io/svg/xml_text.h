#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "relievo/result.h"

namespace relievo {

/// Returns the text of an XML file in UTF-8, without its byte order mark. UTF-16 is told by its
/// mark or by its first characters, a one-byte encoding by the XML declaration. Any of the latter
/// is read as Latin-1, which changes names at most; a warning tells of those that are not.
std::string utf8_text(std::string_view bytes, std::vector<std::string>& warnings);

/// Replaces the general entities that the document type declares in the file itself by their
/// values, and the declarations by blank lines. External entities are never read; references to
/// them and to unknown entities stay, with a warning that names one. Errors: `limit` where the text
/// becomes longer than `max_bytes`, `bad_input` where an entity refers to itself.
Result<std::string> without_entities(std::string text, size_t max_bytes,
                                     std::vector<std::string>& warnings);

}  // namespace relievo
