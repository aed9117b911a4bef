#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::relief {

/// All faces of one part as a mesh of its own, separate from the parts that it is joined to.
struct PartSheet {
  std::vector<int> faces;                     ///< #K in the layered mesh, ascending
  std::vector<std::array<int, 3>> triangles;  ///< #K vertices of the sheet
  std::vector<Point2> positions;              ///< #V, px times the scale
  std::vector<uint8_t> rim;                   ///< #V, 1 on the part's outline, joined or not
  std::vector<uint8_t> seam;                  ///< #V, 1 where the part is joined to another
};

/// Makes the sheet of each part with `wanted[part]`; the others are empty. If `cut_creases`, the
/// two sides of a crease have vertices of their own. O(F * height of the stacks).
std::vector<PartSheet> part_sheets(const LayeredMesh& mesh, const std::vector<bool>& wanted,
                                   bool cut_creases, double scale);

}  // namespace relievo::relief
