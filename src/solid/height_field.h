#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// A place on the plate, in grid steps: x right, y up.
struct GridPoint {
  int64_t x = 0;
  int64_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// What heights are counted from.
struct FloorPoint {
  int64_t height = 0;  ///< steps above the plate
  int part = 0;        ///< that lies behind it
};

/// Heights over a planar triangulation, which may differ between the triangles around a point:
/// there the surface has steps. They are counted from a floor without steps, which changes nothing
/// in what is a manifold. All coordinates are whole steps of a grid that single precision
/// holds, so that tests of order and orientation are exact and files keep what they found.
struct HeightField {
  double unit = 1;                            ///< mm per step, a power of two
  std::vector<GridPoint> points;              ///< #P, distinct
  std::vector<FloorPoint> floor;              ///< #P, or empty: flat, on the plate
  std::vector<int> vertex_point;              ///< #V point below the vertex
  std::vector<int64_t> vertex_height;         ///< #V, steps above the floor
  std::vector<Point3> normals;                ///< #V, unit
  std::vector<Point2> uvs;                    ///< #V, on the drawing
  std::vector<std::array<int, 3>> triangles;  ///< #F vertices, counter-clockwise from the front
  std::vector<int> triangle_part;             ///< #F

  int64_t floor_height(int point) const { return floor.empty() ? 0 : floor[point].height; }
  GridPoint place(int vertex) const { return points[vertex_point[vertex]]; }
};

/// Twice the signed area; positive where a, b, c run counter-clockwise. Exact for coordinates below
/// 2^30.
inline int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How the triangles of a field hang together over the plane, whatever their heights.
struct FieldEdges {
  /// #F x 3: triangle across the edge from corner k to the next, or -1 at the field's rim.
  std::vector<std::array<int, 3>> across;
  int crowded = 0;  ///< edges that more than one triangle has on one side: 0 in a plane
};

/// O(F log F).
FieldEdges connect_field(const HeightField& field);

}  // namespace relievo
