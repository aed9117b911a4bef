#pragma once

#include <optional>
#include <vector>

#include "relief/finish/beside_rim.h"
#include "relief/finish/find_ink.h"
#include "relievo/point.h"

namespace relievo::relief {

/// A map of the canvas onto itself that takes inked outlines to the inner edges of their ink.
///
/// With the distance r to the nearest seen outline point, the move m and the reach R extended from
/// the outline points nearby,
///   x -> x + m (1 - (r / R)^2)^2.
/// Outlines without ink stay. It depends on the place alone, so that surfaces that touch go on to
/// touch.
class DrawIn {
 public:
  explicit DrawIn(const ContourInk& ink);

  /// Returns whether it moves nothing.
  bool empty() const { return !outlines_; }

  /// Returns the image of a place, canvas px, y up. O(outline points nearby).
  Point2 moved(Point2 place) const;

 private:
  struct Move {
    Point2 by;         ///< canvas px
    double reach = 0;  ///< canvas px
  };

  std::vector<Move> moves_;  ///< by outline point
  std::optional<BesideRim> outlines_;
};

/// Moves the vertices of a model, and with them their texture coordinates, which lie on the
/// drawing. Linear in vertices times the outline points nearby.
void draw_in(const DrawIn& map, Model& model);

}  // namespace relievo::relief
