#include "io/svg/svg_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/svg/scanner.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

constexpr double radians = 3.14159265358979323846 / 180;

Affine2 rotation(double degrees) {
  const double s = std::sin(degrees * radians);
  const double c = std::cos(degrees * radians);
  return {c, s, -s, c, 0, 0};
}

std::optional<Affine2> primitive(std::string_view name, const std::vector<double>& v) {
  const size_t n = v.size();
  if (name == "matrix" && n == 6) return Affine2{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return translation(v[0], n == 2 ? v[1] : 0);
  if (name == "scale" && (n == 1 || n == 2)) return scaling(v[0], n == 2 ? v[1] : v[0]);
  if (name == "rotate" && n == 1) return rotation(v[0]);
  if (name == "rotate" && n == 3) {
    return translation(v[1], v[2]) * rotation(v[0]) * translation(-v[1], -v[2]);
  }
  if (name == "skewX" && n == 1) return Affine2{1, 0, std::tan(v[0] * radians), 1, 0, 0};
  if (name == "skewY" && n == 1) return Affine2{1, std::tan(v[0] * radians), 0, 1, 0, 0};
  return std::nullopt;
}

std::optional<std::vector<double>> arguments(SvgScanner& scanner) {
  scanner.skip_space();
  if (!scanner.take('(')) return std::nullopt;
  std::vector<double> values;
  scanner.skip_space();
  while (!scanner.take(')')) {
    const std::optional<double> value = scanner.number();
    if (!value) return std::nullopt;
    values.push_back(*value);
    scanner.skip_separator();
  }
  return values;
}

/// Returns the user units per unit, or 0 for an unknown unit.
double unit_factor(const std::string& unit, const LengthContext& context) {
  if (unit.empty() || unit == "px") return 1;
  if (unit == "pt") return 96.0 / 72;
  if (unit == "pc") return 16;
  if (unit == "mm") return 96 / 25.4;
  if (unit == "cm") return 96 / 2.54;
  if (unit == "in") return 96;
  if (unit == "em") return context.font_size;
  if (unit == "rem") return 16;
  if (unit == "ex") return context.font_size / 2;
  return 0;
}

/// Returns 0, 1/2 or 1 for Min, Mid or Max at `position` of an alignment like xMidYMax.
double alignment(std::string_view align, size_t position) {
  const std::string_view word = align.size() >= position + 3 ? align.substr(position, 3) : "Mid";
  if (word == "Min") return 0;
  return word == "Max" ? 1 : 0.5;
}

/// Reads an absolute length; nothing for one that is missing, relative or not positive.
std::optional<double> absolute_length(const pugi::xml_attribute& attribute) {
  const std::string_view text = trimmed_svg(attribute.value());
  if (text.empty() || text.back() == '%') return std::nullopt;
  const auto value = parse_length(text, LengthAxis::horizontal, {});
  if (!value || !(*value > 0) || !std::isfinite(*value)) return std::nullopt;
  return value;
}

}  // namespace

Affine2 operator*(const Affine2& outer, const Affine2& inner) {
  const Point2 origin = outer({inner.e, inner.f});
  return {outer.a * inner.a + outer.c * inner.b,
          outer.b * inner.a + outer.d * inner.b,
          outer.a * inner.c + outer.c * inner.d,
          outer.b * inner.c + outer.d * inner.d,
          origin.x,
          origin.y};
}

std::optional<Affine2> parse_transform(std::string_view text) {
  SvgScanner scanner(text);
  Affine2 total;
  for (scanner.skip_separator(); !scanner.at_end(); scanner.skip_separator()) {
    const std::string_view name = scanner.word();
    const auto values = arguments(scanner);
    if (!values) return std::nullopt;
    const auto step = primitive(name, *values);
    if (!step) return std::nullopt;
    total = total * *step;
  }
  return total;
}

double reference_length(LengthAxis axis, const LengthContext& context) {
  if (axis == LengthAxis::horizontal) return context.viewport_width;
  if (axis == LengthAxis::vertical) return context.viewport_height;
  return std::hypot(context.viewport_width, context.viewport_height) / std::sqrt(2.0);
}

std::optional<double> parse_length(std::string_view text, LengthAxis axis,
                                   const LengthContext& context) {
  SvgScanner scanner(trimmed_svg(text));
  const std::optional<double> value = scanner.number();
  if (!value) return std::nullopt;
  if (scanner.rest() == "%") return *value / 100 * reference_length(axis, context);
  const double factor = unit_factor(lower_case(scanner.rest()), context);
  if (factor == 0) return std::nullopt;
  return *value * factor;
}

std::optional<ViewBox> parse_view_box(std::string_view text) {
  SvgScanner scanner(text);
  std::array<double, 4> v = {};
  for (double& value : v) {
    scanner.skip_separator();
    const auto number = scanner.number();
    if (!number || !std::isfinite(*number)) return std::nullopt;
    value = *number;
  }
  if (!(v[2] > 0) || !(v[3] > 0)) return std::nullopt;
  return ViewBox{v[0], v[1], v[2], v[3]};
}

Affine2 fit_view_box(const ViewBox& box, double width, double height,
                     std::string_view preserve_aspect_ratio) {
  std::string_view align = next_svg_item(preserve_aspect_ratio);
  if (align == "defer") align = next_svg_item(preserve_aspect_ratio);
  const bool slice = next_svg_item(preserve_aspect_ratio) == "slice";
  double sx = width / box.width;
  double sy = height / box.height;
  if (align != "none") sx = sy = slice ? std::max(sx, sy) : std::min(sx, sy);
  const double x = (width - sx * box.width) * alignment(align, 1);
  const double y = (height - sy * box.height) * alignment(align, 5);
  return translation(x, y) * scaling(sx, sy) * translation(-box.x, -box.y);
}

std::optional<RootSize> root_size(const pugi::xml_node& root) {
  const auto width = absolute_length(root.attribute("width"));
  const auto height = absolute_length(root.attribute("height"));
  const auto box = parse_view_box(root.attribute("viewBox").value());
  if (width && height) return RootSize{*width, *height};
  if (!box) return std::nullopt;
  if (width) return RootSize{*width, *width * box->height / box->width};
  if (height) return RootSize{*height * box->width / box->height, *height};
  return RootSize{box->width, box->height};
}

}  // namespace relievo
