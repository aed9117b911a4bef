#pragma once

#include <string>
#include <string_view>

namespace relievo {

/// Whether `text` is valid UTF-8 (no surrogates, no overlong forms) without control characters.
bool is_plain_utf8(std::string_view text);

/// Whether `id` may name a part: 1 to 200 bytes of plain UTF-8.
bool is_sound_id(std::string_view id);

/// Whether `path` is relative and stays below its folder on every system: segments separated by
/// single '/', none of them empty, "." or "..", no backslash, no colon, plain UTF-8, at most 1000
/// bytes. Says nothing of links on the disk.
bool is_path_inside(std::string_view path);

/// With the letters A to Z made small.
std::string lower_case(std::string_view text);

/// `stem`, or the first of stem-2, stem-3, ... that is not taken.
template <class IsTaken>
std::string free_name(const std::string& stem, const IsTaken& is_taken) {
  std::string name = stem;
  for (int number = 2; is_taken(name); ++number) name = stem + "-" + std::to_string(number);
  return name;
}

}  // namespace relievo
