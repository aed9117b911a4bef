#pragma once

#include "relievo/result.h"
#include "understanding/areas/basins.h"
#include "understanding/labels/scribbles.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// Assigns every pixel to a part or the background. A proposed region becomes the part of the
/// strokes in it. Where strokes of several parts lie in it, its basins are divided by LazyBrush's
/// energy, with hard strokes as constraints and soft ones as votes. A region without strokes
/// becomes a part of its own, or is joined to the scribbled parts where these are complete. Errors:
/// `bad_input` where a stroke or part id is not valid, or where the whole drawing is background;
/// `limit` above 65534 parts. Near-linear in pixels.
Result<Segmentation> label_basins(const Basins& basins, const Scribbles& scribbles = {});

}  // namespace relievo::understanding
