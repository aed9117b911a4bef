#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/model.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The triangles of a part that the front view shows, or those that lie behind another one.
struct TriangleRun {
  int part = 0;
  bool hidden = false;
};

/// Collects vertices and triangles in any order of runs; `build` groups them.
class ModelBuilder {
 public:
  explicit ModelBuilder(const Scene& scene) : scene_(scene) {}

  /// Adds a vertex over a canvas point; returns its index.
  int add_vertex(Point2 canvas, double z, Point3 normal);

  /// Adds a vertex at the place of another.
  int copy_vertex(int vertex, Point3 normal);

  /// Adds a triangle that is counter-clockwise seen from outside. `run`: of its part.
  void add_triangle(TriangleRun run, int a, int b, int c);

  const Point3& position(int vertex) const { return model_.positions[vertex]; }
  const Point3& normal(int vertex) const { return model_.normals[vertex]; }
  void set_position(int vertex, Point3 position) { model_.positions[vertex] = position; }
  void set_height(int vertex, double z) { model_.positions[vertex].z = z; }
  void reserve(size_t vertices, size_t triangles);

  /// The model; triangles of a run keep the order in which they were added. O(triangles).
  Model build() &&;

 private:
  const Scene& scene_;
  Model model_;
  std::vector<TriangleRun> run_;  ///< of every triangle
};

/// Takes vertices out that no triangle uses; the others keep their order. O(vertices + triangles).
void drop_unused_vertices(Model& model);

}  // namespace relievo::relief
