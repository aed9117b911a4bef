#pragma once

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>

namespace relievo {

/// Returns the shortest text that reads back as the same double or float: fixed, or scientific
/// where that is shorter. Equals to_chars, for libraries that lack it. Requires the "C" locale.
template <class Number>
std::string searched_text(Number number) {
  std::array<char, 400> text;
  const auto print = [&](const char* format, int digits) {
    std::snprintf(text.data(), text.size(), format, digits, static_cast<double>(number));
    return std::string(text.data());
  };
  const auto reads_back = [&](const std::string& candidate) {
    if constexpr (std::is_same_v<Number, float>)
      return std::strtof(candidate.c_str(), nullptr) == number;
    return std::strtod(candidate.c_str(), nullptr) == number;
  };
  int digits = 0;
  std::string scientific = print("%.*e", digits);
  while (digits < 17 && !reads_back(scientific)) scientific = print("%.*e", ++digits);
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  const std::string fixed = print("%.*f", digits > exponent ? digits - exponent : 0);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

/// Returns the shortest text that reads back as the same number, in any locale.
template <class Number>
std::string shortest_text(Number number) {
#ifdef __cpp_lib_to_chars
  std::array<char, 32> text;
  const std::to_chars_result result = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), result.ptr};
#else
  if constexpr (std::is_floating_point_v<Number>)
    return searched_text(number);
  else
    return std::to_string(number);
#endif
}

/// Returns "1 part", "2 parts" and so on.
inline std::string counted(size_t number, const std::string& what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

}  // namespace relievo
