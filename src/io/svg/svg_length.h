#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "io/svg/affine.h"

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

struct ViewBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// The viewBox attribute; nothing where it is absent, malformed, not finite or without area.
std::optional<ViewBox> parse_view_box(std::string_view text);

/// Maps the box into a viewport of the given size at the origin as preserveAspectRatio asks.
Affine2 fit_view_box(const ViewBox& box, double width, double height,
                     std::string_view preserve_aspect_ratio);

/// Size of the root viewport in px, before the canvas is scaled.
struct RootSize {
  double width = 0;
  double height = 0;
};

/// From width, height and viewBox of the root; nothing where they do not say it. A missing or
/// relative size follows the viewBox.
std::optional<RootSize> root_size(const pugi::xml_node& root);

}  // namespace relievo
