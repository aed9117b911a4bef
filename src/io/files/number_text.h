#pragma once

#include <array>
#include <charconv>
#include <string>

namespace relievo {

/// The shortest text that reads back as the same number, whatever the locale.
template <class Number>
std::string shortest_text(Number number) {
  std::array<char, 32> text;
  const std::to_chars_result result = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), result.ptr};
}

}  // namespace relievo
