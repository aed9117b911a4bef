#pragma once

#include "relief/layers/sheet_mesh.h"

namespace relievo::relief {

/// Fills the stacks and the arrays of faces of `mesh` (nodes not yet) from its loops and their
/// parts. A part covers a triangle if the winding number of its loops there is not 0; winding
/// numbers are found by a flood fill, in which every crossed edge adds the loops that run along it.
/// Precondition: the loops' edges are edges of the base. O(T log(edges) + F).
void cover_triangles(SheetMesh& mesh);

/// Removes the connected pieces of each part that have less than `least_area`, px^2.
/// Precondition: the sheets are not joined yet. O(T + F).
void drop_specks(double least_area, SheetMesh& mesh);

}  // namespace relievo::relief
