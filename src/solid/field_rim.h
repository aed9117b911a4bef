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

/// Surrounds a field with a flat plate of a height, grid steps, whose triangles belong to `part`
/// and whose vertices have the coordinates `uv`. `outline`: of the plate, grid steps; its rings
/// stay clear of each other and of the field's rim.
Status surround(const Outline& outline, int64_t height, int part, Point2 uv,
                const FieldEdges& edges, HeightField& field);

}  // namespace relievo
