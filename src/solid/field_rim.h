#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// The rim of a field as rings, counter-clockwise around what it covers. O(F).
std::vector<std::vector<int>> rim_rings(const HeightField& field, const FieldEdges& edges);

/// Triangles of points of the rim alone that cover what the field covers, counter-clockwise.
/// O(n log n) for n points of the rim.
Result<std::vector<std::array<int, 3>>> triangulate_inside(const HeightField& field,
                                                           const FieldEdges& edges);

/// A flat plate around a field.
struct Plate {
  Outline outline;     ///< grid steps; its rings stay clear of each other and of the field's rim
  int64_t height = 0;  ///< of its top, grid steps
  int part = 0;        ///< of its triangles
  Point2 uv;           ///< of its vertices
};

/// Adds triangles where the plate's outline covers the plane and the field does not.
Status surround(const Plate& plate, const FieldEdges& edges, HeightField& field);

}  // namespace relievo
