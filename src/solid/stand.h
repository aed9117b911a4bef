#pragma once

#include <cstdint>
#include <vector>

#include "relievo/result.h"
#include "solid/height_field.h"

namespace relievo {

/// A plate that a figure stands on, all lengths in grid steps.
struct Stand {
  bool round = false;             ///< a disc, not a rectangle
  int64_t thickness = 1;          ///< of the plate, whose upper half the feet are sunk into
  int64_t margin = 1;             ///< from the feet to its edge
  int64_t widest = 1;             ///< its sides at most
  int part = 0;                   ///< of its triangles
  Point2 uv;                      ///< of its vertices
  std::vector<GridPoint> others;  ///< x and z of what else stands on it
};

/// Where the triangles of a field reach down to.
int64_t lowest(const HeightField& field);

/// Cuts the field off, level and about `sunk` grid steps above its lowest point. Fails with
/// internal where no clean cut is found. O(F log F).
Status cut_feet(int64_t sunk, HeightField& field);

/// Adds a level plate below the lowest points of a field with a floor, which cut_feet has made,
/// wide enough for all of them and for the centre of mass. Fails with internal where they do not
/// lie on one level. O(F).
Status add_stand(const Stand& stand, HeightField& field);

}  // namespace relievo
