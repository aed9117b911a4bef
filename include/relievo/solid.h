#pragma once

#include <string>
#include <utility>
#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

/// The base of a solid.
enum class BaseShape {
  none,
  outline,  ///< a plate that follows the silhouette
  plate,    ///< a rectangle
  round,    ///< a disc
};

/// The back of a solid.
enum class BackSide {
  flat,
  drawing,  ///< the parts seen from behind, with the drawing on them: a figure
  parts,    ///< the parts seen from behind, each in its mean colour: a figure
};

struct SolidOptions {
  double size = 100;  ///< mm, longest side of the whole except a ring; > 0
  BackSide back = BackSide::flat;
  BaseShape base = BaseShape::none;
  /// Ids of parts of a figure to mirror to its far side: limbs joined to a part behind them.
  std::vector<std::string> mirror;
  double height = 0;     ///< mm, greatest height of the whole, to which depth shrinks; 0: any
  bool detail = false;   ///< whether small forms keep their depth when it shrinks
  double thickness = 2;  ///< mm below the lowest visible point, and of the plate; > 0
  double margin = 3;     ///< mm from the silhouette to the plate's edge, at least 0.5
  double corner = 3;     ///< mm, radius of a rectangle's corners, at most half its shorter side
  double hole = 0;       ///< mm, diameter of a hole in the plate to hang it by; 0: none
  double ring = 0;       ///< mm, diameter of a hole in a loop at the plate's top; 0: none
  double cutter = 0;     ///< mm, height above the plate of a thin wall around it; 0: none
};

/// The names of choices on the command line, in Python and in the browser.
inline constexpr std::pair<const char*, BaseShape> base_shapes[] = {{"none", BaseShape::none},
                                                                    {"outline", BaseShape::outline},
                                                                    {"plate", BaseShape::plate},
                                                                    {"round", BaseShape::round}};
inline constexpr std::pair<const char*, BackSide> back_sides[] = {
    {"flat", BackSide::flat}, {"drawing", BackSide::drawing}, {"parts", BackSide::parts}};

/// A length among the options.
struct SolidLength {
  const char* name;
  double SolidOptions::*value;
  double least;  ///< mm; 0 is accepted too if it is the default
  double most;   ///< mm
  const char* text;
};

inline constexpr SolidLength solid_lengths[] = {
    {"size", &SolidOptions::size, 1, 10000, "Longest side in mm (default 100)"},
    {"thickness", &SolidOptions::thickness, 0.1, 1000,
     "Of solid: mm below its lowest visible point; also of a base (default 2)"},
    {"height", &SolidOptions::height, 0.2, 1000,
     "Of solid and figure: greatest depth in mm, to which it shrinks"},
    {"margin", &SolidOptions::margin, 0.5, 1000,
     "Of solid and figure: mm from it, or its feet, to the edge of its base (default 3)"},
    {"corner", &SolidOptions::corner, 0, 1000,
     "Of solid: mm, radius of the corners of a plate (default 3)"},
    {"hole", &SolidOptions::hole, 0.5, 100, "Of solid: diameter in mm of a hole in its base"},
    {"ring", &SolidOptions::ring, 0.5, 100,
     "Of solid: diameter in mm of the hole of a loop above its base"},
    {"cutter", &SolidOptions::cutter, 1, 1000,
     "Of solid: height in mm of a wall 0.8 mm thick around --base outline, to cut dough"}};

/// Returns whether the solid is printed upright instead of lying: a figure on a base.
inline bool stands(const SolidOptions& options) {
  return options.back != BackSide::flat && options.base != BaseShape::none;
}

/// Turns a point of a lying solid upright: the drawing's up, Y, becomes the bed's up, Z.
inline Point3 stood_up(Point3 p) { return {p.x, -p.z, p.y}; }

struct SolidFacts {
  double volume = 0;               ///< mm^3
  int pieces = 0;                  ///< number of connected pieces
  std::vector<std::string> loose;  ///< parts of all pieces but the largest
};

/// A closed model for printers and mills, and the picture on it.
struct Solid {
  Model model;      ///< in mm instead of px: lying on z = 0, the corner of its box at the origin
  Drawing drawing;  ///< empty if there is none
  SolidFacts facts;
};

}  // namespace relievo
