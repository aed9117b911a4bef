#pragma once

#include <optional>
#include <string_view>

#include "kernel/image/color.h"

namespace relievo {

/// #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla(), transparent and the named
/// colours; nothing where it is none of them.
std::optional<Color> parse_color(std::string_view text);

}  // namespace relievo
