#pragma once

#include <string>
#include <vector>

#include "relievo/point.h"

namespace relievo::understanding {

enum class ScribbleKind {
  soft,     ///< votes: is overruled where most of its area belongs to others
  hard,     ///< what it covers belongs to its part; cuts areas where no line does
  outside,  ///< what it covers, and all that is open to it, is background
  hole,     ///< the area around it, up to its lines and bridges, is background
};

/// A stroke of a round brush.
struct Scribble {
  ScribbleKind kind = ScribbleKind::hard;
  int part = 0;                ///< index into Scribbles::parts; says nothing for outside and hole
  std::vector<Point2> points;  ///< polyline, drawing px; one point is a dot
  double width = 1;            ///< px, > 0
};

/// What a person says about the parts of a drawing.
struct Scribbles {
  std::vector<std::string> parts;  ///< ids, unique
  std::vector<Scribble> strokes;
  /// Whether the parts with strokes are all that there are, so that they take what of the figure no
  /// stroke touches; else that stays as proposed.
  bool complete = false;
  /// So many parts are proposed, or as near to it as can be; 0: as many as are found.
  int count = 0;
};

}  // namespace relievo::understanding
