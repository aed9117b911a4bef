#pragma once

#include <cstdint>
#include <vector>

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// A plate that a figure stands on. Lengths are in grid steps.
struct Stand {
  bool round = false;             ///< a disc instead of a rectangle
  int64_t thickness = 1;          ///< the feet are sunk into the upper half
  int64_t margin = 1;             ///< from the feet to the plate's edge
  int64_t widest = 1;             ///< longest side, at most
  int part = 0;                   ///< of its triangles
  Point2 uv;                      ///< of its vertices
  std::vector<GridPoint> others;  ///< x and z of other points that must stand on it
};

/// Returns the lowest y of the triangles of a field.
int64_t lowest(const HeightField& field);

/// Cuts the field off, level and about `sunk` grid steps above its lowest point. Fails with
/// internal if no clean cut is found. O(F log F).
Status cut_feet(int64_t sunk, HeightField& field);

/// Adds a level plate below the feet of a field with a floor that cut_feet has cut, wide enough for
/// all feet and for the centre of mass. Fails with internal if the feet are not on one level. O(F).
Status add_stand(const Stand& stand, HeightField& field);

}  // namespace relievo
