#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace relievo {

/// Reads the values of SVG attributes from left to right, in any locale. A failed read keeps the
/// position.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  std::string_view rest() const { return rest_; }

  void skip_space();
  /// Skips white space with at most one comma in it.
  void skip_separator();
  bool take(char c);

  /// Reads a number of the SVG grammar; "1.5em" gives 1.5 and stops at "em". An exponent that
  /// overflows gives an infinity.
  std::optional<double> number();

  /// Reads an arc flag: one character, 0 or 1, that needs no separator after it.
  std::optional<bool> flag();

  /// Reads letters and hyphens; may be empty.
  std::string_view word();

 private:
  std::string_view rest_;
};

std::string_view trimmed_svg(std::string_view text);

/// Takes the next comma- or space-separated item from the front of `text`; empty at the end.
std::string_view next_svg_item(std::string_view& text);

}  // namespace relievo
