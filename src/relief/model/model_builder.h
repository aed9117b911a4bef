#pragma once

#include <vector>

#include "relief/model/model.h"
#include "relief/scene/scene.h"

namespace relievo {

/// Collects vertices and triangles in any order of parts; `build` groups them by part.
class ModelBuilder {
 public:
  explicit ModelBuilder(const Scene& scene) : scene_(scene) {}

  /// Adds a vertex over a canvas point; returns its index.
  int add_vertex(Point2 canvas, double z, Point3 normal);

  /// Adds a vertex at the place of another.
  int copy_vertex(int vertex, Point3 normal);

  /// Adds a triangle that is counter-clockwise seen from outside.
  void add_triangle(int part, int a, int b, int c);

  const Point3& position(int vertex) const { return model_.positions[vertex]; }
  const Point3& normal(int vertex) const { return model_.normals[vertex]; }
  void set_position(int vertex, Point3 position) { model_.positions[vertex] = position; }
  void set_height(int vertex, double z) { model_.positions[vertex].z = z; }
  void reserve(size_t vertices, size_t triangles);

  /// The model; triangles of a part keep the order in which they were added. O(triangles).
  Model build() &&;

 private:
  const Scene& scene_;
  Model model_;
  std::vector<int> triangle_part_;
};

}  // namespace relievo
