#pragma once

#include <pugixml.hpp>
#include <string_view>

#include "io/svg/path_data.h"
#include "io/svg/svg_values.h"

namespace relievo {

/// Returns whether the element is a path, rect, circle, ellipse, line, polyline or polygon.
bool is_shape_element(std::string_view local_name);

/// Returns the outline of a shape element in its user units; empty where its geometry disables it
/// (a zero radius). `complete` becomes whether all of its data could be read.
PathData shape_path(const pugi::xml_node& element, const LengthContext& context, bool& complete);

}  // namespace relievo
