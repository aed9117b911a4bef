#include "io/svg/scanner.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Appends the digits from `i` on to `mantissa` and returns their count. Digits beyond the
/// precision of a double only move the decimal point.
int read_digits(std::string_view text, size_t& i, double& mantissa, int& dropped) {
  int count = 0;
  for (; i < text.size() && is_digit(text[i]); ++i, ++count) {
    if (mantissa < 1e17) {
      mantissa = 10 * mantissa + (text[i] - '0');
    } else {
      ++dropped;
    }
  }
  return count;
}

/// Reads the exponent at `i` ("e-3"); 0 where there is none.
int read_exponent(std::string_view text, size_t& i) {
  if (i >= text.size() || (text[i] != 'e' && text[i] != 'E')) return 0;
  size_t j = i + 1;
  bool negative = false;
  if (j < text.size() && (text[j] == '+' || text[j] == '-')) negative = text[j++] == '-';
  if (j >= text.size() || !is_digit(text[j])) return 0;
  int value = 0;
  for (; j < text.size() && is_digit(text[j]); ++j)
    value = std::min(9999, 10 * value + text[j] - '0');
  i = j;
  return negative ? -value : value;
}

double scaled(double mantissa, int exponent) {
  if (mantissa == 0) return 0;
  if (exponent < -300) return mantissa * 1e-300 * std::pow(10.0, exponent + 300);
  return exponent < 0 ? mantissa / std::pow(10.0, -exponent) : mantissa * std::pow(10.0, exponent);
}

}  // namespace

void SvgScanner::skip_space() {
  while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
}

void SvgScanner::skip_separator() {
  skip_space();
  if (take(',')) skip_space();
}

bool SvgScanner::take(char c) {
  if (rest_.empty() || rest_.front() != c) return false;
  rest_.remove_prefix(1);
  return true;
}

std::optional<double> SvgScanner::number() {
  size_t i = 0;
  bool negative = false;
  if (i < rest_.size() && (rest_[i] == '+' || rest_[i] == '-')) negative = rest_[i++] == '-';
  double mantissa = 0;
  int shift = 0;
  int digits = read_digits(rest_, i, mantissa, shift);
  if (i < rest_.size() && rest_[i] == '.') {
    ++i;
    int dropped = 0;
    const int fraction = read_digits(rest_, i, mantissa, dropped);
    shift -= fraction - dropped;
    digits += fraction;
  }
  if (digits == 0) return std::nullopt;
  const double value = scaled(mantissa, shift + read_exponent(rest_, i));
  rest_.remove_prefix(i);
  return negative ? -value : value;
}

std::optional<bool> SvgScanner::flag() {
  if (peek() != '0' && peek() != '1') return std::nullopt;
  const bool value = peek() == '1';
  rest_.remove_prefix(1);
  return value;
}

std::string_view SvgScanner::word() {
  size_t n = 0;
  while (n < rest_.size() && (is_letter(rest_[n]) || rest_[n] == '-')) ++n;
  const std::string_view found = rest_.substr(0, n);
  rest_.remove_prefix(n);
  return found;
}

std::string_view trimmed_svg(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view next_svg_item(std::string_view& text) {
  const auto separates = [](char c) { return is_space(c) || c == ','; };
  while (!text.empty() && separates(text.front())) text.remove_prefix(1);
  const auto end = std::find_if(text.begin(), text.end(), separates);
  const std::string_view item = text.substr(0, static_cast<size_t>(end - text.begin()));
  text.remove_prefix(item.size());
  return item;
}

}  // namespace relievo
