#pragma once

#include <string>
#include <vector>

#include "relievo/point.h"

namespace relievo::understanding {

enum class ScribbleKind {
  soft,     ///< votes for its part: overruled where most of the area belongs to others
  hard,     ///< gives its pixels to its part; cuts areas where no line does
  outside,  ///< makes its pixels, and all that is open to them, background
  hole,     ///< makes the area around it, up to its lines and bridges, background
};

/// Returns whether strokes of a kind belong to a part; others are for the background.
inline bool is_for_part(ScribbleKind kind) {
  return kind == ScribbleKind::soft || kind == ScribbleKind::hard;
}

/// A stroke of a round brush.
struct Scribble {
  ScribbleKind kind = ScribbleKind::hard;
  int part = 0;                ///< index into Scribbles::parts; unused unless is_for_part(kind)
  std::vector<Point2> points;  ///< polyline, drawing px; one point is a dot
  double width = 1;            ///< px, > 0

  /// Returns the label that the stroke stands for: 0 background, part + 1 else.
  int label() const { return is_for_part(kind) ? part + 1 : 0; }
};

/// A person's corrections of the parts of a drawing.
struct Scribbles {
  std::vector<std::string> parts;  ///< ids, unique
  std::vector<Scribble> strokes;
  /// The parts with strokes are the only ones: they take all of the figure that no stroke touches.
  /// Else that stays as proposed.
  bool complete = false;
  /// Number of parts to propose, or as near to it as possible; 0: as many as are found.
  int count = 0;
};

}  // namespace relievo::understanding
