#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "relievo/point.h"

namespace relievo {

/// The map x' = a x + c y + e, y' = b x + d y + f.
struct Affine2 {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 1;
  double e = 0;
  double f = 0;

  Point2 operator()(Point2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }

  /// Returns the mean factor of lengths: the root of the area factor.
  double mean_scale() const { return std::sqrt(std::abs(a * d - b * c)); }
};

/// Returns the map that applies `inner` first, then `outer`.
Affine2 operator*(const Affine2& outer, const Affine2& inner);

inline Affine2 translation(double x, double y) { return {1, 0, 0, 1, x, y}; }
inline Affine2 scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }

/// Reads a list of matrix, translate, scale, rotate, skewX and skewY; nothing where it is
/// malformed.
std::optional<Affine2> parse_transform(std::string_view text);

/// The lengths that relative units refer to, in user units.
struct LengthContext {
  double font_size = 16;
  double viewport_width = 0;
  double viewport_height = 0;
};

/// The length of the viewport that a percentage refers to.
enum class LengthAxis { horizontal, vertical, diagonal };

/// Reads a length (px, pt, pc, mm, cm, in, em, ex, rem, % or no unit; 1 in = 96 px) in user units.
/// Nothing where it is malformed; not necessarily finite.
std::optional<double> parse_length(std::string_view text, LengthAxis axis,
                                   const LengthContext& context);

/// Returns the size of the viewport along the axis; along the diagonal sqrt((w^2 + h^2) / 2).
double reference_length(LengthAxis axis, const LengthContext& context);

struct ViewBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// Reads a viewBox attribute; nothing where it is absent, malformed, not finite or without area.
std::optional<ViewBox> parse_view_box(std::string_view text);

/// Returns the map of the box into a viewport of this size at the origin, by preserveAspectRatio.
Affine2 fit_view_box(const ViewBox& box, double width, double height,
                     std::string_view preserve_aspect_ratio);

/// Size of the root viewport in px, before the canvas is scaled.
struct RootSize {
  double width = 0;
  double height = 0;
};

/// Returns the size from width, height and viewBox of the root; nothing where they do not state it.
/// A missing or relative side follows the viewBox.
std::optional<RootSize> root_size(const pugi::xml_node& root);

}  // namespace relievo
