#pragma once

#include <optional>
#include <string_view>

#include "kernel/image/color.h"

namespace relievo {

/// Reads #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla(), transparent or a colour
/// keyword; nothing for any other text.
std::optional<Color> parse_color(std::string_view text);

}  // namespace relievo
