#pragma once

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

}  // namespace relievo
