#include "understanding/areas/find_basins.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/image/blur.h"
#include "kernel/image/distance_transform.h"
#include "kernel/image/morphology.h"
#include "kernel/image/watershed.h"
#include "understanding/areas/basin_graph.h"
#include "understanding/areas/cut_necks.h"
#include "understanding/areas/divide_at_cut.h"
#include "understanding/areas/propose_regions.h"
#include "understanding/areas/settle_edges.h"
#include "understanding/lines/colour_edges.h"
#include "understanding/lines/line_gaps.h"
#include "understanding/lines/line_map.h"
#include "understanding/lines/stroke_ends.h"
#include "understanding/paper/lay_on_white.h"
#include "understanding/paper/pure_white.h"
#include "understanding/perception/perceive.h"

namespace relievo::understanding {
namespace {

constexpr int least_contour = 100;         ///< probability, of 255, of contours that bound basins
constexpr double contour_margin = 2.5;     ///< cells, distance up to which lines stand for contours
constexpr double smallest_inradius = 1.5;  ///< px; narrower basins are gaps inside double strokes
/// A peak has its own basin if it rises 1.5 px above the pass to a higher one and that is at most
/// 0.9 times as high.
constexpr BasinOptions peak_options{.min_rise = 1.5, .max_pass_ratio = 0.9};

/// Floods the distance to the barrier from its peaks, and the barrier from these basins, the palest
/// ink first. Returns the basin of every pixel, and no pixels where there are no basins.
Image<int32_t> watershed(const LineMap& map, std::vector<Basin>& basins) {
  PeakBasins found = peak_basins(squared_distance_to(map.barrier), peak_options);
  std::vector<int32_t> number(found.peaks.size(), 0);
  for (size_t k = 1; k < found.peaks.size(); ++k) {
    if (found.peaks[k] < smallest_inradius) continue;
    basins.emplace_back();
    basins.back().inradius = found.peaks[k];
    number[k] = static_cast<int32_t>(basins.size());
  }
  for (int32_t& label : found.label.pixels) label = number[label];
  if (basins.empty()) return {};
  flood_from_seeds(box_blur(map.ink, std::max(1, static_cast<int>(map.line_width / 4))),
                   found.label);
  for (int32_t& label : found.label.pixels) --label;
  return std::move(found.label);
}

void close_line_gaps(const Image8& rgb, LineMap& map) {
  const std::vector<StrokeEnd> ends = find_loose_ends(map);
  for (const LineGap& gap : find_open_roots(ends, map))
    close_gap(gap, LineMap::bridge, map.barrier);
  for (const LineGap& gap : find_broken_outlines(ends, map, rgb))
    close_gap(gap, LineMap::gap, map.barrier);
}

/// Sets what is perceived at every pixel.
void look_up(const Perception& seen, int width, int height, Basins& basins) {
  basins.front = seen.front;
  basins.figure = at_pixels(seen.figure, seen.cell, width, height);
  basins.contour = at_pixels(seen.contour, seen.cell, width, height);
  basins.near_contour =
      max_filter(basins.contour, std::max(1, static_cast<int>(std::lround(seen.cell))));
}

/// Reports progress. Returns false where the run was cancelled.
bool go_on(const RunContext& context, double done) {
  context.report("find areas", done);
  return !context.cancelled();
}

}  // namespace

Result<Basins> find_basins(const Drawing& drawing, const Network& network,
                           const RunContext& context) {
  if (drawing.rgba.empty()) return Error{ErrorCode::bad_input, "the drawing has no pixels", ""};
  if (!go_on(context, 0)) return interrupted_error();
  const auto seen = perceive(drawing.rgba, network);
  if (!seen) return seen.error();
  const Image8& rgba = drawing.rgba;
  const bool on_pure_white = is_on_pure_white(rgba);
  const Image8 rgb = lay_on_white(rgba, on_pure_white);
  if (!go_on(context, 0.1)) return interrupted_error();
  LineMap map = find_lines(rgb, on_pure_white);
  close_line_gaps(rgb, map);
  if (!go_on(context, 0.5)) return interrupted_error();
  Basins basins;
  look_up(*seen, rgba.width, rgba.height, basins);
  basins.cut_out = is_cut_out(rgba, basins.figure);
  if (basins.cut_out) add_cut_edges(rgba, map);
  const Image8 drawn = map.barrier;  // colours tell nothing beside contours that nobody drew
  add_contours(basins.contour, least_contour,
               static_cast<int>(std::lround(contour_margin * seen->cell)), map);
  const std::vector<uint8_t>& barrier = map.barrier.pixels;
  if (std::all_of(barrier.begin(), barrier.end(), [](uint8_t b) { return b == LineMap::none; }))
    return Error{ErrorCode::bad_input, "the drawing is blank: no line or edge was found in it", ""};
  basins.index = watershed(map, basins.basins);
  if (basins.basins.empty())
    return Error{ErrorCode::bad_input, "the drawing has no areas between its lines", ""};
  if (!go_on(context, 0.9)) return interrupted_error();
  settle_edges(rgb, drawn, basins.index);
  if (basins.cut_out) divide_at_cut(rgba, static_cast<int>(basins.basins.size()), basins.index);
  basins.ink = std::move(map.ink);
  basins.barrier = std::move(map.barrier);
  basins.line_width = map.line_width;
  measure_basins(rgba, rgb, basins);
  propose_regions(basins);
  if (cut_necks(basins)) measure_basins(rgba, rgb, basins);
  context.report("find areas", 1);
  return basins;
}

}  // namespace relievo::understanding
