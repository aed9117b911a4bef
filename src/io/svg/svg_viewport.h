#pragma once

#include <pugixml.hpp>

#include "io/svg/svg_values.h"

namespace relievo {

/// Returns the size of a nested <svg> or a used <symbol>, which `sized` may override.
RootSize viewport_of(const pugi::xml_node& element, const pugi::xml_node& sized,
                     const LengthContext& lengths);

/// Returns the translation by the element's x and y.
Affine2 placement_of(const pugi::xml_node& element, const LengthContext& lengths);

/// Returns the map of the element's viewBox, if it has one, into its viewport of this size, and
/// sets the viewport that lengths inside refer to.
Affine2 enter_viewport(const pugi::xml_node& element, RootSize size, LengthContext& lengths);

}  // namespace relievo
