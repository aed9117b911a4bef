#pragma once

#include <string>
#include <string_view>

namespace relievo {

/// Returns whether `text` is valid UTF-8 (no surrogates, no overlong forms) without control
/// characters.
bool is_plain_utf8(std::string_view text);

/// Returns whether `id` may name a part: 1 to 200 bytes of plain UTF-8.
bool is_sound_id(std::string_view id);

/// Returns whether `path` is relative and stays below its folder on every system: segments
/// separated by single '/', none of them empty, "." or "..", no backslash, no colon, plain UTF-8,
/// at most 1000 bytes. Does not look at symbolic links on the disk.
bool is_path_inside(std::string_view path);

/// Returns `text` with the letters A to Z in lower case.
std::string lower_case(std::string_view text);

/// Returns an XML text from its first tag or document type on: without leading white space,
/// comments and processing instructions.
std::string_view after_prolog(std::string_view xml);

/// Returns `stem`, or the first of stem-2, stem-3, ... that is not taken.
template <class IsTaken>
std::string free_name(const std::string& stem, const IsTaken& is_taken) {
  std::string name = stem;
  for (int number = 2; is_taken(name); ++number) name = stem + "-" + std::to_string(number);
  return name;
}

}  // namespace relievo
