#include "io/svg/svg_viewport.h"

namespace relievo {

RootSize viewport_of(const pugi::xml_node& element, const pugi::xml_node& sized,
                     const LengthContext& lengths) {
  const auto size = [&](const char* name, LengthAxis axis) {
    pugi::xml_attribute attribute = sized.attribute(name);
    if (!attribute) attribute = element.attribute(name);
    return parse_length(attribute.value(), axis, lengths).value_or(reference_length(axis, lengths));
  };
  return {size("width", LengthAxis::horizontal), size("height", LengthAxis::vertical)};
}

Affine2 placement_of(const pugi::xml_node& element, const LengthContext& lengths) {
  const auto at = [&](const char* name, LengthAxis axis) {
    return parse_length(element.attribute(name).value(), axis, lengths).value_or(0);
  };
  return translation(at("x", LengthAxis::horizontal), at("y", LengthAxis::vertical));
}

Affine2 enter_viewport(const pugi::xml_node& element, RootSize size, LengthContext& lengths) {
  const auto box = parse_view_box(element.attribute("viewBox").value());
  lengths.viewport_width = box ? box->width : size.width;
  lengths.viewport_height = box ? box->height : size.height;
  if (!box) return {};
  return fit_view_box(*box, size.width, size.height,
                      element.attribute("preserveAspectRatio").value());
}

}  // namespace relievo
