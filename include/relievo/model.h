#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// Which faces of a relief a model keeps.
enum class Visibility {
  relief,  ///< the front part over each base triangle, with vertical walls between: to print
  orbit,   ///< whole parts, except faces that a part with d < 0 covers: to turn
  all,     ///< every face
};

/// The triangles of one part, consecutive in the model.
struct ModelPart {
  std::string id;
  double c = 4;
  double d = 1;
  double flat = 0;
  Point2 lean{};
  int first_triangle = 0;
  int triangle_count = 0;
  int hidden_count = 0;  ///< the last so many triangles lie behind another part in the front view,
                         ///< so that the drawing has no colours for them

  /// One past the last triangle.
  int end() const { return first_triangle + triangle_count; }
  /// One past the last triangle that is not hidden.
  int seen_end() const { return end() - hidden_count; }
};

/// The treatment of the contours of a drawing, the ink along the outlines of its parts.
enum class Ink {
  shell,  ///< lines that turn with the model: a mesh of their own (Model::ink)
  paint,  ///< colours of the surface, as drawn: bands on its sides when the model is turned
  none,   ///< the paint beside them goes on to the outline
};

/// The contours of a drawing as a mesh of their own, without light and seen from one side alone.
struct InkMesh {
  std::vector<Point3> positions;              ///< [vertices] px
  std::vector<Point2> uvs;                    ///< [vertices] as those of the model
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// A triangle mesh with a picture's coordinates. Model space is in canvas px: X right, Y up, Z
/// towards the viewer; the canvas spans x in [0, width] and y in [0, height]; z = 0 is the drawing
/// plane of f. Triangles of a smooth surface share vertices; where the surface is open, vertices
/// are doubled.
struct Model {
  double width = 0;               ///< canvas, px
  double height = 0;              ///< canvas, px
  std::vector<Point3> positions;  ///< [vertices] px
  std::vector<Point3> normals;    ///< [vertices] unit
  std::vector<Point2> uvs;        ///< [vertices] [0, 1] on the drawing, origin top-left, v down
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<ModelPart> parts;               ///< back to front; their triangles are disjoint runs
  InkMesh ink;                                ///< empty if no contours are drawn
  /// Whether export_model still has to finish the contours and hidden triangles of a surface. Other
  /// models, such as solids, are written as they are.
  bool unfinished = false;

  /// Returns the number of triangles with those of the ink.
  size_t all_triangles() const { return triangles.size() + ink.triangles.size(); }
};

struct ModelOptions {
  Visibility visibility = Visibility::orbit;
  /// Faces are cut so that the surface departs from g + sgn(u) sqrt|u|, u and g linear on every
  /// face, by less than this, px; at least 1e-6.
  double rim_tolerance = 0.25;
  /// A face is cut into at most 4^max_rim_levels pieces; the tolerance is doubled for the whole
  /// model until that holds. In [0, 8].
  int max_rim_levels = 4;
};

/// The heights h = f + g or one of the two summands [P Fig. 4].
enum class Field {
  relief,     ///< h
  inflation,  ///< f
  shift,      ///< g
};

}  // namespace relievo
