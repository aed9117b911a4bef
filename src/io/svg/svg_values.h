#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "kernel/image/color.h"
#include "relievo/point.h"

namespace relievo {

/// Reads the values of SVG attributes from left to right, in any locale. A failed read keeps the
/// position.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  std::string_view rest() const { return rest_; }

  void skip_space();
  /// Skips white space with at most one comma in it.
  void skip_separator();
  bool take(char c);

  /// Reads a number of the SVG grammar; "1.5em" gives 1.5 and stops at "em". An exponent that
  /// overflows gives an infinity.
  std::optional<double> number();

  /// Reads an arc flag: one character, 0 or 1, that needs no separator after it.
  std::optional<bool> flag();

  /// Reads letters and hyphens; may be empty.
  std::string_view word();

 private:
  std::string_view rest_;
};

std::string_view trimmed_svg(std::string_view text);

/// Returns the name of an element or attribute without its namespace prefix.
std::string_view local_name(std::string_view name);

/// Takes the next comma- or space-separated item from the front of `text`; empty at the end.
std::string_view next_svg_item(std::string_view& text);

/// Reads #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla(), transparent or a colour
/// keyword; nothing for any other text.
std::optional<Color> parse_color(std::string_view text);

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

/// Returns the inverse map. Precondition: it has one.
Affine2 inverse(const Affine2& m);

inline Affine2 translation(double x, double y) { return {1, 0, 0, 1, x, y}; }
inline Affine2 scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }

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

/// Returns the user units per unit (px, pt, ...), given in lower case, or 0 for an unknown one.
double unit_factor(const std::string& unit, const LengthContext& context);

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
