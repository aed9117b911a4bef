#pragma once

#include <optional>
#include <string_view>

namespace relievo {

/// What relative units refer to, in user units.
struct LengthContext {
  double font_size = 16;
  double viewport_width = 0;
  double viewport_height = 0;
};

/// What a percentage is of.
enum class LengthAxis { horizontal, vertical, diagonal };

/// A length in user units (1 in = 96 px): px, pt, pc, mm, cm, in, em, ex, rem, % or no unit.
/// Nothing where it is malformed; not necessarily finite.
std::optional<double> parse_length(std::string_view text, LengthAxis axis,
                                   const LengthContext& context);

/// How large a viewport is along the axis; along the diagonal sqrt((w^2 + h^2) / 2).
double reference_length(LengthAxis axis, const LengthContext& context);

}  // namespace relievo
