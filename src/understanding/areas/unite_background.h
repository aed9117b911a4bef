#pragma once

#include "understanding/areas/basins.h"
#include "understanding/areas/region_merging.h"

namespace relievo::understanding {

/// Unites all regions of the background and returns that region, or -1 where there is none. The
/// background is: regions of the paper's colour at the picture's border, except a large one that
/// reaches one edge only (a figure that the border cuts off) and a small one that lines bound on
/// all other sides; everything around a page; all transparent regions of a drawing with opaque
/// areas; and regions that are quite open to any of these. Regions inside the figure's mask never
/// are. Removes the lines around a page from `basins`.
int unite_background(RegionMerging& regions, Basins& basins);

/// Returns whether a region is as white as paper is after its light has been divided out.
bool is_paper(const Basin& region);

/// Computes the share of the lines, by area, that have background on all sides.
double unbounded_line_share(const Basins& basins);

}  // namespace relievo::understanding
