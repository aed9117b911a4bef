#pragma once

#include "relievo/result.h"
#include "understanding/areas/basins.h"
#include "understanding/labels/scribbles.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// Gives every basin to a part or the background. A proposed region becomes the part of the
/// strokes in it; where there are several, its basins are divided by LazyBrush's energy, hard
/// strokes as constraints, soft ones as votes. Regions without strokes stay, or are divided among
/// the parts that have some where those are complete. Errors: `bad_input` where a stroke or part id
/// is not valid, or where nothing but background and lines is left; `limit` above 65534 parts.
/// Near-linear in pixels.
Result<Segmentation> label_basins(const Basins& basins, const Scribbles& scribbles = {});

}  // namespace relievo::understanding
