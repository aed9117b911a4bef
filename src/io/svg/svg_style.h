#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/svg/svg_document.h"
#include "io/svg/svg_values.h"
#include "kernel/image/color.h"

namespace relievo {

enum class FillRule { nonzero, even_odd };

enum class LineCap { butt, round, square };

enum class LineJoin { miter, round, bevel };

/// A fill or stroke: nothing, a colour, or a paint server with an optional fallback.
struct SvgPaint {
  std::optional<Color> color;         ///< or the fallback of the server
  std::optional<std::string> server;  ///< id of the gradient or pattern; empty where it is foreign
};

/// The computed style of one element. The first group is inherited, the second is not.
struct SvgStyle {
  SvgPaint fill{Color(), std::nullopt};
  SvgPaint stroke;
  Color color;
  double fill_opacity = 1;
  double stroke_opacity = 1;
  double stroke_width = 1;  ///< user units
  double miter_limit = 4;
  double font_size = 16;  ///< user units
  FillRule fill_rule = FillRule::nonzero;
  FillRule clip_rule = FillRule::nonzero;
  LineCap cap = LineCap::butt;
  LineJoin join = LineJoin::miter;
  bool visible = true;

  double opacity = 1;
  bool displayed = true;
  bool clips_overflow = true;  ///< of nested viewports
  std::string clip_path;       ///< id; may be empty
  std::string mask;            ///< likewise
  std::string filter;          ///< likewise
  bool blends = false;         ///< with what lies below, by multiply, screen, ...
  bool isolates = false;       ///< what is in it blends with nothing outside
};

/// Computes the style of `element` from its parent's style, its presentation attributes and its
/// style attribute. Values that cannot be read are ignored.
SvgStyle computed_style(const pugi::xml_node& element, const SvgStyle& parent,
                        const LengthContext& context);

/// Returns the id in "url(#id)" or "#id"; empty where the reference is not local.
std::string local_reference(std::string_view text);

/// Returns one colour that stands for the paint: its own, the mean of a gradient's stops along the
/// gradient, or grey for a pattern. A gradient has the alpha of its most transparent stop, since
/// one that fades out is shading. Nothing where the paint draws nothing.
std::optional<Color> representative_color(const SvgPaint& paint, const SvgDocument& document);

}  // namespace relievo
