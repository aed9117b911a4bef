#include "io/svg/svg_viewport.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/svg/scanner.h"

namespace relievo {
namespace {

/// 0, 1/2 or 1 of the free space for Min, Mid or Max at `position` of an alignment like xMidYMax.
double alignment(std::string_view align, size_t position) {
  const std::string_view word = align.size() >= position + 3 ? align.substr(position, 3) : "Mid";
  if (word == "Min") return 0;
  return word == "Max" ? 1 : 0.5;
}

/// An absolute length, or nothing for one that is missing, relative or not positive.
std::optional<double> absolute_length(const pugi::xml_attribute& attribute) {
  const std::string_view text = trimmed_svg(attribute.value());
  if (text.empty() || text.back() == '%') return std::nullopt;
  const auto value = parse_length(text, LengthAxis::horizontal, {});
  if (!value || !(*value > 0) || !std::isfinite(*value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<ViewBox> parse_view_box(std::string_view text) {
  SvgScanner scanner(text);
  std::array<double, 4> v = {};
  for (double& value : v) {
    scanner.skip_separator();
    const auto number = scanner.number();
    if (!number || !std::isfinite(*number)) return std::nullopt;
    value = *number;
  }
  if (!(v[2] > 0) || !(v[3] > 0)) return std::nullopt;
  return ViewBox{v[0], v[1], v[2], v[3]};
}

Affine2 fit_view_box(const ViewBox& box, double width, double height,
                     std::string_view preserve_aspect_ratio) {
  std::string_view align = next_svg_item(preserve_aspect_ratio);
  if (align == "defer") align = next_svg_item(preserve_aspect_ratio);
  const bool slice = next_svg_item(preserve_aspect_ratio) == "slice";
  double sx = width / box.width;
  double sy = height / box.height;
  if (align != "none") sx = sy = slice ? std::max(sx, sy) : std::min(sx, sy);
  const double x = (width - sx * box.width) * alignment(align, 1);
  const double y = (height - sy * box.height) * alignment(align, 5);
  return translation(x, y) * scaling(sx, sy) * translation(-box.x, -box.y);
}

std::optional<RootSize> root_size(const pugi::xml_node& root) {
  const auto width = absolute_length(root.attribute("width"));
  const auto height = absolute_length(root.attribute("height"));
  const auto box = parse_view_box(root.attribute("viewBox").value());
  if (width && height) return RootSize{*width, *height};
  if (!box) return std::nullopt;
  if (width) return RootSize{*width, *width * box->height / box->width};
  if (height) return RootSize{*height * box->width / box->height, *height};
  return RootSize{box->width, box->height};
}

}  // namespace relievo
