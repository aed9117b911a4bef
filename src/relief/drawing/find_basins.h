#pragma once

#include <vector>

#include "relief/drawing/basin_votes.h"
#include "relief/drawing/basins.h"
#include "relief/drawing/scribbles.h"
#include "relief/drawing/segmentation.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// Divides a drawing into basins by the watershed of the distance to its lines, and proposes which
/// of them make one part. Errors: `bad_input` where the drawing is empty or holds no line,
/// `interrupted`. Near-linear in pixels; the context is looked at between steps, the longest of
/// which takes a third of the whole.
Result<Basins> find_basins(const Drawing& drawing, const RunContext& context = {});

/// Whether hard strokes of different labels lie in one basin.
bool needs_split(const BasinVotes& votes);

/// Divides every basin that hard strokes claim for several labels into one for each, by a
/// watershed from the strokes that meets at the narrowest place between them, and moves the hard
/// pixels of `votes` to the new basins. O(pixels in the boxes of these basins).
Basins split_basins(Basins basins, BasinVotes& votes);

/// Fills `basins` and `borders` from index, ink, barrier and figure. `rgba` is the drawing, `rgb`
/// the same on white. O(pixels + border pixels log border pixels).
void measure_basins(const Image8& rgba, const Image8& rgb, Basins& basins);

/// Fills `borders` from index, ink and barrier. O(border pixels log border pixels).
void measure_borders(const Image8& rgb, Basins& basins);

/// The borders between basins inside a window of pixels, its end excluded; sorted by a, b. Without
/// steps of colour.
std::vector<BasinBorder> borders_within(const Basins& basins, int x0, int y0, int x1, int y1);

/// The label of every basin: 0 background, k + 1 Scribbles::parts[k] (#P of them), #P + r the
/// proposed region r. Minimises LazyBrush's energy over the basins that strokes leave free.
std::vector<int> choose_labels(const Basins& basins, const BasinVotes& votes,
                               const Scribbles& scribbles);

/// Gives every basin to a part or the background. A proposed region becomes the part of the
/// strokes in it; where there are several, its basins are divided by LazyBrush's energy, hard
/// strokes as constraints, soft ones as votes. Regions without strokes stay, or are divided among
/// the parts that have some where those are complete. Errors: `bad_input` where a stroke or part id
/// is not valid, or where nothing but background and lines is left; `limit` above 65534 parts.
/// Near-linear in pixels.
Result<Segmentation> label_basins(const Basins& basins, const Scribbles& scribbles = {});

}  // namespace relievo
