#pragma once

#include "relievo/image.h"
#include "understanding/areas/basins.h"
#include "understanding/areas/region_merging.h"

namespace relievo::understanding {

/// Unites all regions that are background and returns that region, or -1 where there is none: what
/// has the paper's colour and reaches the edge of the image, what lies around the page, and what is
/// quite open to these. A large region that reaches one edge only is taken for a figure that the
/// edge cuts, and so is a small one that lines bound all around but there. Where areas of the
/// drawing are opaque, all transparent ones are background. What lies in the figure's mask never
/// is.
int unite_background(RegionMerging& regions, Basins& basins);

/// Whether a region is as white as paper is, once its colour is divided out.
bool is_paper(const Basin& region);

/// Share of the lines, by area, on all sides of which lies the background.
double unbounded_line_share(const Basins& basins);

}  // namespace relievo::understanding
