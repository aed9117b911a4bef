#pragma once

#include <optional>
#include <string_view>

namespace relievo {

/// sRGB with straight alpha, all in [0, 1].
struct SvgColor {
  double r = 0;
  double g = 0;
  double b = 0;
  double a = 1;
};

/// #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla(), transparent and the named
/// colours; nothing where it is none of them.
std::optional<SvgColor> parse_color(std::string_view text);

/// Euclidean distance of the colours without alpha, in [0, sqrt 3].
double color_distance(const SvgColor& p, const SvgColor& q);

}  // namespace relievo
