#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/geometry/point.h"

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
  int hidden_count = 0;  ///< the last so many of them lie behind another part in the front view
};

/// A surface ready for files and pictures. Model space in canvas px: X right, Y up, Z to the
/// viewer; the canvas spans x in [0, width], y in [0, height]; z = 0 is the drawing plane of f.
/// Vertices are shared between triangles of a smooth surface, and doubled where it is open.
struct Model {
  double width = 0;               ///< canvas, px
  double height = 0;              ///< canvas, px
  std::vector<Point3> positions;  ///< #V, px
  std::vector<Point3> normals;    ///< #V, unit
  std::vector<Point2> uvs;        ///< #V, [0, 1] on the drawing, origin top-left, v down
  std::vector<std::array<int, 3>> triangles;  ///< #F, counter-clockwise seen from outside
  std::vector<ModelPart> parts;               ///< back to front; their triangles are disjoint runs
};

}  // namespace relievo
