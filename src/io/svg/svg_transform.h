#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/svg/svg_values.h"
#include "relievo/point.h"

namespace relievo {

/// The box to which the lengths and percentages of a transform refer.
struct TransformBox {
  Point2 corner;          ///< of the reference box, user units
  LengthContext lengths;  ///< its viewport is the reference box
};

/// Reads a list of transform functions in the grammar of the attribute or of CSS: matrix,
/// translate, scale, rotate and skew, those of one axis, and those in space as far as they keep to
/// the plane. Lengths may have units or be percentages of the box, angles are degrees or have deg,
/// rad, grad or turn. "none" and an empty text are no transform; a malformed one gives nothing.
std::optional<Affine2> parse_transform(std::string_view text, const TransformBox& box = {});

/// Returns whether every renderer reads the text as parse_transform does: it has the functions and
/// plain numbers of SVG 1.1 alone.
bool is_plain_transform(std::string_view text);

/// Reads the value of transform-origin, in user units: "left", "50% 10px", "center bottom".
std::optional<Point2> parse_transform_origin(std::string_view text, const TransformBox& box);

/// Returns the map as the value of a transform attribute.
std::string transform_text(const Affine2& map);

}  // namespace relievo
