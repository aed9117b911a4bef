#include "io/svg/svg_length.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "io/svg/scanner.h"

namespace relievo {
namespace {

/// User units per unit, or 0 where the unit is not known.
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

}  // namespace

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
  std::string unit(scanner.rest());
  std::transform(unit.begin(), unit.end(), unit.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const double factor = unit_factor(unit, context);
  if (factor == 0) return std::nullopt;
  return *value * factor;
}

}  // namespace relievo
