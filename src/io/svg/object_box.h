#pragma once

#include <cstddef>
#include <pugixml.hpp>

#include "io/svg/svg_document.h"
#include "io/svg/svg_values.h"
#include "kernel/geometry/polygon.h"

namespace relievo {

/// A search for the boxes of objects of a document.
struct BoxSearch {
  const SvgDocument& document;
  double tolerance = 0.01;       ///< of curves, user units
  size_t max_work = 10'000'000;  ///< elements and their curves looked at, all searches together
  size_t work = 0;

  bool gave_up() const { return work > max_work; }
};

/// Returns the box around the fills of an element and all in it, strokes and clips left out, in the
/// user units in which the element is placed; empty where it has none. Its own transform does not
/// count. Texts have no box. Where the search gives up, the box is empty.
Box2 object_box(const pugi::xml_node& element, const LengthContext& lengths, BoxSearch& search);

}  // namespace relievo
