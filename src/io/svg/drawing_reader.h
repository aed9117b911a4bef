#pragma once

#include "io/svg/svg_reading.h"

namespace relievo {

/// Reads all elements in `parent` into the drawing, until the reading has an error.
void read_children(const pugi::xml_node& parent, const InheritedState& around, Reading& reading);

}  // namespace relievo
