#pragma once

#include <vector>

#include "relievo/model.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Collects vertices and triangles of parts in any order; `build` groups the triangles by part.
class ModelBuilder {
 public:
  explicit ModelBuilder(const Scene& scene) : scene_(scene) {}

  /// Adds a vertex over a canvas point; returns its index.
  int add_vertex(Point2 canvas, double z, Point3 normal);

  /// Adds a vertex at the position of another; returns its index.
  int copy_vertex(int vertex, Point3 normal);

  /// Adds a triangle of a part that is counter-clockwise seen from outside. `hidden`: whether it
  /// lies behind another part in the front view.
  void add_triangle(int part, bool hidden, int a, int b, int c);

  const Point3& position(int vertex) const { return model_.positions[vertex]; }
  const Point3& normal(int vertex) const { return model_.normals[vertex]; }
  void set_position(int vertex, Point3 position) { model_.positions[vertex] = position; }
  void set_height(int vertex, double z) { model_.positions[vertex].z = z; }
  void reserve(size_t vertices, size_t triangles);

  /// Returns the model; within a part, seen triangles come before hidden ones, and both keep the
  /// order in which they were added. O(triangles).
  Model build() &&;

 private:
  const Scene& scene_;
  Model model_;
  std::vector<int> run_;  ///< of every triangle: 2 part, plus 1 if it is hidden
};

/// Removes vertices that no triangle uses; the others keep their order. O(vertices + triangles).
void drop_unused_vertices(Model& model);

}  // namespace relievo::relief
