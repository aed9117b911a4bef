#include "io/svg/svg_transform.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "io/files/number_text.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

constexpr double radians = std::numbers::pi / 180;  ///< of a degree

/// An argument of a function, with its unit as text.
struct Argument {
  double value = 0;
  std::string unit;
};

Affine2 rotation(double degrees) {
  const double s = std::sin(degrees * radians);
  const double c = std::cos(degrees * radians);
  return {c, s, -s, c, 0, 0};
}

Affine2 skewing(double x_degrees, double y_degrees) {
  return {1, std::tan(y_degrees * radians), std::tan(x_degrees * radians), 1, 0, 0};
}

std::optional<double> degrees_of(const Argument& a) {
  if (a.unit.empty() || a.unit == "deg") return a.value;
  if (a.unit == "rad") return a.value / radians;
  if (a.unit == "grad") return a.value * 0.9;
  if (a.unit == "turn") return a.value * 360;
  return std::nullopt;
}

std::optional<double> factor_of(const Argument& a) {
  if (a.unit == "%") return a.value / 100;
  return a.unit.empty() ? std::optional(a.value) : std::nullopt;
}

std::optional<double> length_of(const Argument& a, LengthAxis axis, const TransformBox& box) {
  if (a.unit == "%") return a.value / 100 * reference_length(axis, box.lengths);
  const double factor = unit_factor(a.unit, box.lengths);
  return factor == 0 ? std::nullopt : std::optional(a.value * factor);
}

/// Takes a unit of letters, or %; may be empty.
std::string take_unit(SvgScanner& scanner) {
  std::string unit;
  if (scanner.take('%')) return "%";
  for (char c = scanner.peek(); std::isalpha(static_cast<unsigned char>(c)); c = scanner.peek()) {
    unit.push_back(c);
    scanner.take(c);
  }
  return lower_case(unit);
}

/// Takes "(20px, 5%)" from the front; nothing where it is malformed.
std::optional<std::vector<Argument>> take_arguments(SvgScanner& scanner) {
  scanner.skip_space();
  if (!scanner.take('(')) return std::nullopt;
  std::vector<Argument> list;
  scanner.skip_space();
  while (!scanner.take(')')) {
    const std::optional<double> value = scanner.number();
    if (!value) return std::nullopt;
    list.push_back({*value, take_unit(scanner)});
    scanner.skip_separator();
  }
  return list;
}

/// The numbers of one function, all read in the same way; empty where one cannot be.
template <class Read>
std::vector<double> numbers_of(const std::vector<Argument>& arguments, const Read& read) {
  std::vector<double> values;
  for (const Argument& argument : arguments) {
    const std::optional<double> value = read(argument);
    if (!value) return {};
    values.push_back(*value);
  }
  return values;
}

std::optional<Affine2> moved(std::string_view name, const std::vector<Argument>& a,
                             const TransformBox& box) {
  const auto x = [&](size_t i) { return length_of(a[i], LengthAxis::horizontal, box); };
  const auto y = [&](size_t i) { return length_of(a[i], LengthAxis::vertical, box); };
  const size_t n = a.size();
  const std::string_view axis = name.substr(9);
  std::optional<double> dx = 0;
  std::optional<double> dy = 0;
  if (axis == "X" && n == 1) {
    dx = x(0);
  } else if (axis == "Y" && n == 1) {
    dy = y(0);
  } else if ((axis.empty() && (n == 1 || n == 2)) || (axis == "3d" && n == 3)) {
    dx = x(0);
    if (n > 1) dy = y(1);
  } else if (axis != "Z" || n != 1) {
    return std::nullopt;
  }
  if (!dx || !dy) return std::nullopt;
  return translation(*dx, *dy);
}

std::optional<Affine2> scaled_by(std::string_view name, const std::vector<double>& v) {
  const size_t n = v.size();
  const std::string_view axis = name.substr(5);
  if (axis == "X" && n == 1) return scaling(v[0], 1);
  if (axis == "Y" && n == 1) return scaling(1, v[0]);
  if (axis == "Z" && n == 1) return Affine2();
  if (axis.empty() && (n == 1 || n == 2)) return scaling(v[0], v[n - 1]);
  return axis == "3d" && n == 3 ? std::optional(scaling(v[0], v[1])) : std::nullopt;
}

std::optional<Affine2> turned(std::string_view name, const std::vector<Argument>& a,
                              const TransformBox& box) {
  const size_t n = a.size();
  const auto angle = n == 0 ? std::nullopt : degrees_of(a[0]);
  if (!angle) return std::nullopt;
  if (name == "rotate" && n == 3) {
    const auto x = length_of(a[1], LengthAxis::horizontal, box);
    const auto y = length_of(a[2], LengthAxis::vertical, box);
    if (!x || !y) return std::nullopt;
    return translation(*x, *y) * rotation(*angle) * translation(-*x, -*y);
  }
  if (n != 1) return std::nullopt;
  if (name == "rotate" || name == "rotateZ") return rotation(*angle);
  if (name == "rotateX") return scaling(1, std::cos(*angle * radians));
  return name == "rotateY" ? std::optional(scaling(std::cos(*angle * radians), 1)) : std::nullopt;
}

std::optional<Affine2> skewed(std::string_view name, const std::vector<double>& v) {
  if (name == "skewX" && v.size() == 1) return skewing(v[0], 0);
  if (name == "skewY" && v.size() == 1) return skewing(0, v[0]);
  if (name == "skew" && v.size() == 1) return skewing(v[0], 0);
  return name == "skew" && v.size() == 2 ? std::optional(skewing(v[0], v[1])) : std::nullopt;
}

std::optional<Affine2> function(std::string_view name, const std::vector<Argument>& a,
                                const TransformBox& box) {
  if (name.starts_with("translate")) return moved(name, a, box);
  if (name.starts_with("rotate")) return turned(name, a, box);
  if (name.starts_with("skew")) return skewed(name, numbers_of(a, degrees_of));
  const std::vector<double> v = numbers_of(a, factor_of);
  if (name.starts_with("scale")) return scaled_by(name, v);
  if (name == "matrix" && v.size() == 6) return Affine2{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "matrix3d" && v.size() == 16) return Affine2{v[0], v[1], v[4], v[5], v[12], v[13]};
  return name == "perspective" ? std::optional(Affine2()) : std::nullopt;
}

/// Takes the name of a function: letters, and the digit of "translate3d".
std::string take_function_name(SvgScanner& scanner) {
  std::string name(scanner.word());
  if (scanner.take('3')) name += "3" + std::string(scanner.word());
  return name;
}

/// A place along one axis: 0, 1/2 or 1 for a keyword.
std::optional<double> keyword_place(std::string_view word) {
  if (word == "left" || word == "top") return 0;
  if (word == "center") return 0.5;
  return word == "right" || word == "bottom" ? std::optional(1.0) : std::nullopt;
}

std::optional<double> place(std::string_view word, LengthAxis axis, const TransformBox& box) {
  if (const auto share = keyword_place(word)) return *share * reference_length(axis, box.lengths);
  return parse_length(word, axis, box.lengths);
}

}  // namespace

std::optional<Affine2> parse_transform(std::string_view text, const TransformBox& box) {
  SvgScanner scanner(text);
  Affine2 total;
  if (trimmed_svg(text) == "none") return total;
  for (scanner.skip_separator(); !scanner.at_end(); scanner.skip_separator()) {
    const std::string name = take_function_name(scanner);
    const auto arguments = take_arguments(scanner);
    const auto step = arguments ? function(name, *arguments, box) : std::nullopt;
    if (!step) return std::nullopt;
    total = total * *step;
  }
  return total;
}

bool is_plain_transform(std::string_view text) {
  constexpr std::array<std::string_view, 6> names = {"matrix", "translate", "scale",
                                                     "rotate", "skewX",     "skewY"};
  SvgScanner scanner(text);
  for (scanner.skip_separator(); !scanner.at_end(); scanner.skip_separator()) {
    const std::string name = take_function_name(scanner);
    const auto arguments = take_arguments(scanner);
    const bool known = std::find(names.begin(), names.end(), name) != names.end();
    if (!known || !arguments || !function(name, *arguments, {})) return false;
    for (const Argument& argument : *arguments)
      if (!argument.unit.empty()) return false;
  }
  return true;
}

std::optional<Point2> parse_transform_origin(std::string_view text, const TransformBox& box) {
  const std::string words = lower_case(text);
  std::string_view rest = words;
  std::string_view first = next_svg_item(rest);
  std::string_view second = next_svg_item(rest);
  if (second.empty()) second = "center";
  const bool swapped = first == "top" || first == "bottom" || second == "left" || second == "right";
  if (swapped) std::swap(first, second);
  const auto x = place(first, LengthAxis::horizontal, box);
  const auto y = place(second, LengthAxis::vertical, box);
  if (!x || !y) return std::nullopt;
  return box.corner + Point2{*x, *y};
}

std::string transform_text(const Affine2& map) {
  std::string text = "matrix(";
  for (const double value : {map.a, map.b, map.c, map.d, map.e, map.f})
    text += (text.back() == '(' ? "" : " ") + shortest_text(value);
  return text + ")";
}

}  // namespace relievo
