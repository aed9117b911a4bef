#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/svg/stylesheet.h"
#include "io/svg/svg_document.h"
#include "io/svg/svg_units.h"
#include "kernel/image/color.h"

namespace relievo {

enum class FillRule { nonzero, even_odd };

enum class LineCap { butt, round, square };

enum class LineJoin { miter, round, bevel };

/// What fills or strokes: nothing, a colour, or a paint server with an optional fallback.
struct SvgPaint {
  enum class Kind { none, color, server };
  Kind kind = Kind::none;
  Color color;  ///< of kind color, or the fallback of a server
  bool has_fallback = false;
  std::string server;  ///< id of the gradient or pattern
};

/// Computed style of one element. The first group is inherited, the second is not.
struct SvgStyle {
  SvgPaint fill{SvgPaint::Kind::color, {}, false, ""};
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
  bool clips_overflow = true;            ///< of nested viewports
  std::string clip_path;                 ///< id, or empty
  std::string mask;                      ///< id, or empty
  std::string filter;                    ///< likewise
  std::optional<std::string> transform;  ///< from CSS only
};

/// The style of `element` from its presentation attributes, the sheet and its style attribute, on
/// top of its parent's. Values that cannot be read are as if absent.
SvgStyle computed_style(const pugi::xml_node& element, const Stylesheet& sheet,
                        const SvgStyle& parent, const LengthContext& context);

/// The id in "url(#id)" or "#id"; empty where the reference is not local.
std::string local_reference(std::string_view text);

/// One colour that stands for the paint: its own, or the mean of a gradient's stops along the
/// gradient, or grey for a pattern. A gradient is as transparent as its most transparent stop, for
/// one that fades out is shading. Nothing where the paint draws nothing.
std::optional<Color> representative_color(const SvgPaint& paint, const SvgDocument& document);

}  // namespace relievo
