#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// A point of the plate, in grid steps: x right, y up.
struct GridPoint {
  int64_t x = 0;
  int64_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Returns a point in floating point.
inline Point2 as_point(GridPoint p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// A point of the floor that heights are counted from.
struct FloorPoint {
  int64_t height = 0;  ///< grid steps above the plate
  int part = 0;        ///< the part behind it
};

/// Heights over a planar triangulation. They may differ between the triangles around a point: there
/// the surface has steps. They are counted from a floor without steps, so that a manifold over the
/// plate is one over the floor. All coordinates are whole steps of a grid that single precision
/// represents, so that tests of order and orientation are exact and hold for files too.
struct HeightField {
  double unit = 1;                            ///< mm per step, a power of two
  std::vector<GridPoint> points;              ///< #P, distinct
  std::vector<FloorPoint> floor;              ///< #P, or empty: the plate
  std::vector<int> vertex_point;              ///< #V point below the vertex
  std::vector<int64_t> vertex_height;         ///< #V, steps above the floor
  std::vector<Point3> normals;                ///< #V, unit
  std::vector<Point2> uvs;                    ///< #V, on the drawing
  std::vector<std::array<int, 3>> triangles;  ///< #F vertices, counter-clockwise from the front
  std::vector<int> triangle_part;             ///< #F

  int64_t floor_height(int point) const { return floor.empty() ? 0 : floor[point].height; }
  GridPoint place(int vertex) const { return points[vertex_point[vertex]]; }
  int corner_vertex(int corner) const { return triangles[corner / 3][corner % 3]; }
  /// Returns the height at (1 - s) a + s b, rounded.
  int64_t height_between(int a, int b, double s) const;

  /// Adds a vertex; returns its index.
  int add_vertex(int point, int64_t height, Point3 normal, Point2 uv);
  /// Adds a vertex with the normal and texture coordinates at (1 - s) a + s b; returns its index.
  int add_vertex_between(int a, int b, double s, int point, int64_t height);
};

/// Returns twice the signed area, positive if a, b, c run counter-clockwise. Exact for coordinates
/// below 2^30.
inline int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The connections of a field's triangles over the plane, regardless of their heights.
struct FieldEdges {
  /// #F x 3 triangle across the edge from corner k to the next, or -1 at the field's rim.
  std::vector<std::array<int, 3>> across;
  int crowded = 0;  ///< number of edges with several triangles on one side: 0 in a plane
};

/// Connects triangles that share an edge over the plane. O(F log F).
FieldEdges connect_field(const HeightField& field);

/// The corners around points, as 3 * triangle + k, counter-clockwise. A point at which the field
/// touches itself has several fans.
struct CornerFans {
  std::vector<int> begin;    ///< #fans + 1
  std::vector<int> corners;  ///< those of fan i are [begin[i], begin[i + 1])
  std::vector<char> closed;  ///< #fans; others begin and end at the field's rim

  size_t size() const { return closed.size(); }
};

/// Collects the fans of all points: open ones, then closed ones, both by their first corner.
/// Linear.
CornerFans collect_fans(const HeightField& field, const FieldEdges& edges);

}  // namespace relievo
