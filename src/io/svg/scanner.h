#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace relievo {

/// Reads the small languages inside SVG attributes from left to right. Independent of the locale.
/// A failed read leaves the position where it was.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  std::string_view rest() const { return rest_; }

  void skip_space();
  /// White space with at most one comma in it.
  void skip_separator();
  bool take(char c);

  /// A number of the SVG grammar; "1.5em" yields 1.5 and stops at "em". An exponent that
  /// overflows yields an infinity.
  std::optional<double> number();

  /// An arc flag: one character, 0 or 1, that needs no separator after it.
  std::optional<bool> flag();

  /// Letters and hyphens; empty where there is none.
  std::string_view word();

 private:
  std::string_view rest_;
};

std::string_view trimmed_svg(std::string_view text);

/// Next comma- or space-separated item of `text`, which is shortened by it; empty at the end.
std::string_view next_svg_item(std::string_view& text);

}  // namespace relievo
