#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// The triangles of one part, consecutive in the model.
struct ModelPart {
  std::string id;
  double c = 4;
  double d = 1;
  double flat = 0;
  Point2 lean{};
  int first_triangle = 0;
  int triangle_count = 0;
  int hidden_count = 0;  ///< the last so many of them lie behind another part in the front view,
                         ///< and have no colours in the drawing
};

/// A surface ready for files and pictures. Model space in canvas px: X right, Y up, Z to the
/// viewer; the canvas spans x in [0, width], y in [0, height]; z = 0 is the drawing plane of f.
/// Vertices are shared between triangles of a smooth surface, and doubled where it is open.
struct Model {
  double width = 0;               ///< canvas, px
  double height = 0;              ///< canvas, px
  std::vector<Point3> positions;  ///< [vertices] px
  std::vector<Point3> normals;    ///< [vertices] unit
  std::vector<Point2> uvs;        ///< [vertices] [0, 1] on the drawing, origin top-left, v down
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<ModelPart> parts;               ///< back to front; their triangles are disjoint runs
};

enum class Visibility {
  relief,  ///< top part per base triangle, with vertical walls between open edges: to print
  orbit,   ///< whole sheets, except lower faces covered by a part with d < 0: to turn
  all,     ///< every face, hidden ones too
};

struct ModelOptions {
  Visibility visibility = Visibility::orbit;
  /// Faces are cut so that the surface departs from g + sgn(u) sqrt|u|, u and g linear on every
  /// face, by less than this, px; at least 1e-6.
  double rim_tolerance = 0.25;
  /// A face is cut in at most 4^levels pieces, or else the tolerance is doubled for the whole
  /// model until that holds; in [0, 8].
  int max_rim_levels = 4;
};

/// The heights and what they are the sum of, h = f + g [P Fig. 4].
enum class Field {
  relief,     ///< h
  inflation,  ///< f
  shift,      ///< g
};

}  // namespace relievo
