#pragma once

#include "io/svg/svg_reading.h"

namespace relievo {

/// Returns the shape that an <image> shows; nothing where it shows none, with a warning.
std::optional<SvgShape> picture_shape(const pugi::xml_node& image, const InheritedState& around,
                                      Reading& reading);

/// Cuts a shape that a pattern fills with one picture to what is opaque of it. `element` is the
/// shape's.
void fill_with_picture(const pugi::xml_node& element, const InheritedState& around, SvgShape& shape,
                       Reading& reading);

}  // namespace relievo
