#pragma once

#include <string>
#include <utility>
#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

/// What a solid stands on.
enum class BaseShape {
  none,     ///< nothing but itself
  outline,  ///< a plate that follows its silhouette
  plate,    ///< a rectangle
  round,    ///< a disc
};

/// What lies behind a solid.
enum class BackSide {
  flat,    ///< the plate
  plain,   ///< its parts again, from behind: a figure. Their paint, without marks such as a face
  mirror,  ///< likewise, with the drawing on them, mirrored
  parts,   ///< likewise, each part with the mean of its colours
};

struct SolidOptions {
  double size = 100;  ///< mm, longest side of the whole, a ring aside; > 0
  BackSide back = BackSide::flat;
  BaseShape base = BaseShape::none;  ///< none behind what has no flat back
  /// Ids of parts of a figure that its far side gets too: limbs joined to a part behind them.
  std::vector<std::string> mirror;
  double height = 0;     ///< mm, of the whole at most: depth shrinks where there is more; 0: any
  bool detail = false;   ///< whether small forms keep their depth then, as far as that goes
  double thickness = 2;  ///< mm below the lowest point that is seen, and of the plate; > 0
  double margin = 3;     ///< mm from the silhouette to the plate's edge, at least 0.5
  double corner = 3;     ///< mm, radius of a rectangle's corners; at most its half side counts
  double hole = 0;       ///< mm, diameter of a hole in the plate to hang it by; 0: none
  double ring = 0;       ///< mm, diameter of a hole in a loop at the plate's top; 0: none
  double cutter = 0;     ///< mm, height above the plate of a thin wall around it; 0: none
  Ink ink = Ink::none;   ///< shells are for pictures and games: they are no part of the body
  double ink_width = 1;  ///< factor by which shells are wider than the contours drawn
};

/// What choices are called on the command line, in Python and in the browser.
inline constexpr std::pair<const char*, BaseShape> base_shapes[] = {{"none", BaseShape::none},
                                                                    {"outline", BaseShape::outline},
                                                                    {"plate", BaseShape::plate},
                                                                    {"round", BaseShape::round}};
inline constexpr std::pair<const char*, BackSide> back_sides[] = {
    {"flat", BackSide::flat},
    {"plain", BackSide::plain},
    {"mirror", BackSide::mirror},
    {"drawing", BackSide::mirror},  // its former name
    {"parts", BackSide::parts}};

/// A length among the options.
struct SolidLength {
  const char* name;
  double SolidOptions::*value;
  double least;  ///< mm; where 0 stands for none, that is taken too
  double most;   ///< mm
  const char* text;
};

inline constexpr SolidLength solid_lengths[] = {
    {"size", &SolidOptions::size, 1, 10000, "Longest side in mm (default 100)"},
    {"thickness", &SolidOptions::thickness, 0.1, 1000,
     "Thickness in mm of a solid below its lowest visible point, and of a base (default 2)"},
    {"height", &SolidOptions::height, 0.2, 1000,
     "Maximum depth of a solid or figure in mm; a deeper one is compressed"},
    {"margin", &SolidOptions::margin, 0.5, 1000,
     "Distance in mm from a solid, or the feet of a figure, to the edge of the base (default 3)"},
    {"corner", &SolidOptions::corner, 0, 1000,
     "Radius in mm of the corners of a plate (default 3)"},
    {"hole", &SolidOptions::hole, 0.5, 100,
     "Makes a hole of this diameter in mm in the base of a solid"},
    {"ring", &SolidOptions::ring, 0.5, 100,
     "Adds a loop above the base of a solid, with a hole of this diameter in mm"},
    {"cutter", &SolidOptions::cutter, 1, 1000,
     "Adds a wall of 0.8 mm around --base outline, this many mm high, to make a cookie cutter"}};

/// Whether a printer makes it standing, not lying: a figure on a base.
inline bool stands(const SolidOptions& options) {
  return options.back != BackSide::flat && options.base != BaseShape::none;
}

/// The place of what stands: what was up on the drawing is up on the bed, Y becomes Z.
inline Point3 stood_up(Point3 p) { return {p.x, -p.z, p.y}; }

struct SolidFacts {
  double volume = 0;               ///< mm^3
  int pieces = 0;                  ///< that do not hang together
  std::vector<std::string> loose;  ///< parts of all pieces but the largest
};

/// A closed model for printers and mills, and the picture that lies on it.
struct Solid {
  Model model;      ///< in mm, not px: lying on z = 0, its box's corner in the origin
  Drawing drawing;  ///< empty where there is none
  SolidFacts facts;
};

}  // namespace relievo
