#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// Returns the rim of a field as rings of points, counter-clockwise around the field. O(F).
std::vector<std::vector<int>> rim_rings(const HeightField& field, const FieldEdges& edges);

/// Triangulates the area of a field with points of its rim alone; the triangles are
/// counter-clockwise. O(n log n) for n points of the rim.
Result<std::vector<std::array<int, 3>>> triangulate_inside(const HeightField& field,
                                                           const FieldEdges& edges);

/// A flat plate around a field.
struct Plate {
  Outline outline;     ///< grid steps; its rings stay clear of each other and of the field's rim
  int64_t height = 0;  ///< grid steps of its top
  int part = 0;        ///< of its triangles
  Point2 uv;           ///< of its vertices
};

/// Adds triangles in the plate's outline around the field.
Status surround(const Plate& plate, const FieldEdges& edges, HeightField& field);

}  // namespace relievo
