#pragma once

#include <vector>

#include "solid/height_field.h"

namespace relievo {

inline int corner_vertex(const HeightField& field, int corner) {
  return field.triangles[corner / 3][corner % 3];
}

/// Where backs lie on the drawing.
struct BackPaint {
  Point2 plate;  ///< a flat one
  std::vector<Point2>
      parts;  ///< a floor's, by part and of a base; empty: as what is in front of it
};

}  // namespace relievo
