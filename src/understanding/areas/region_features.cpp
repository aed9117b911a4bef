#include "understanding/areas/region_features.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "kernel/base/exact_functions.h"
#include "understanding/areas/boosted_trees.h"

namespace relievo::understanding {
namespace {

constexpr double certain = 100;  ///< log-odds

constexpr TreeNode one_part_trees[] = {
#include "understanding/areas/one_part_trees.inc"
};

constexpr TreeNode figure_trees[] = {
#include "understanding/areas/figure_trees.inc"
};

double standard_deviation(const Basin& region) {
  if (region.coloured == 0) return 0;
  const auto count = static_cast<double>(region.coloured);
  double variance = static_cast<double>(region.colour_squares) / count;
  for (const double mean : mean_colour(region)) variance -= mean * mean;
  return std::sqrt(std::max(0.0, variance));
}

double pixels_at_edge(const Basin& region) {
  return static_cast<double>(
      std::accumulate(region.at_edge.begin(), region.at_edge.end(), int64_t{0}));
}

double length_of_border(const RegionMerging& regions, int r) {
  return pixels_at_edge(regions.region(r)) + static_cast<double>(regions.whole_border(r).pairs);
}

double figure_probability(const Basin& region) {
  return static_cast<double>(region.figure) /
         (255.0 * static_cast<double>(std::max<int64_t>(1, region.area)));
}

/// Computes the mean figure_probability of the neighbours, by the length of their borders.
double figure_around(const RegionMerging& regions, int r) {
  double sum = 0;
  double length = 0;
  for (const auto& [neighbour, border] : regions.borders(r)) {
    sum += static_cast<double>(border.pairs) * figure_probability(regions.region(neighbour));
    length += static_cast<double>(border.pairs);
  }
  return length > 0 ? sum / length : 0;
}

bool is_transparent(const Basin& region) { return 2 * region.transparent > region.area; }

double distance_of_colours(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return std::sqrt(sum);
}

}  // namespace

DrawingMeasure measure_drawing(const Basins& basins) {
  DrawingMeasure drawing;
  double figure = 0;
  double at_edge = 0;
  std::array<double, 3> sum = {};
  for (const Basin& basin : basins.basins) {
    figure += static_cast<double>(basin.figure) / 255;
    if (basin.coloured == 0) continue;
    const std::array<double, 3> mean = mean_colour(basin);
    for (size_t c = 0; c < 3; ++c) sum[c] += pixels_at_edge(basin) * mean[c];
    at_edge += pixels_at_edge(basin);
  }
  for (size_t c = 0; c < 3; ++c) drawing.paper[c] = at_edge > 0 ? sum[c] / at_edge : 255;
  drawing.figure = std::max(1.0, figure);
  drawing.cut_out = basins.cut_out;
  drawing.picture = static_cast<double>(basins.index.width) * basins.index.height;
  drawing.diagonal = std::hypot(basins.index.width, basins.index.height);
  return drawing;
}

PairFeatures features_of(const RegionMerging& regions, const DrawingMeasure& drawing, int a,
                         int b) {
  if (regions.region(a).area > regions.region(b).area) std::swap(a, b);
  const Basin& smaller = regions.region(a);
  const Basin& larger = regions.region(b);
  const Border& border = regions.borders(a).at(b);
  const auto length = static_cast<double>(border.pairs);
  const auto mean = [length](int64_t sum) { return static_cast<double>(sum) / length; };
  const auto log_area = [&](const Basin& region) {
    return exact::log(static_cast<double>(region.area) / drawing.figure);
  };
  const double figure_a = figure_probability(smaller);
  const double figure_b = figure_probability(larger);
  return {mean(border.contour) / 255,
          mean(border.near_contour) / 255,
          mean(border.on_contour),
          mean(border.line_pairs),
          mean(border.edge_pairs),
          mean(border.ink) / 255,
          regions.colour_step(a, b),
          smaller.coloured > 0 && larger.coloured > 0
              ? distance_of_colours(mean_colour(smaller), mean_colour(larger))
              : 0,
          log_area(smaller),
          log_area(larger),
          length / length_of_border(regions, a),
          length / length_of_border(regions, b),
          std::abs(figure_a - figure_b),
          std::min(figure_a, figure_b),
          std::min(smaller.inradius, larger.inradius) / drawing.diagonal,
          std::max(standard_deviation(smaller), standard_deviation(larger)),
          length / drawing.diagonal};
}

RegionFeatures features_of(const RegionMerging& regions, const DrawingMeasure& drawing, int r) {
  const Basin& region = regions.region(r);
  const Border border = regions.whole_border(r);
  const auto length = std::max(1.0, static_cast<double>(border.pairs));
  const auto area = static_cast<double>(std::max<int64_t>(1, region.area));
  return {figure_probability(region),
          figure_around(regions, r),
          pixels_at_edge(region) / (pixels_at_edge(region) + length),
          static_cast<double>(std::count_if(region.at_edge.begin(), region.at_edge.end(),
                                            [](int64_t pixels) { return pixels > 0; })),
          exact::log(area / drawing.picture),
          region.coloured > 0 ? distance_of_colours(mean_colour(region), drawing.paper) : 0,
          static_cast<double>(border.near_contour) / (255 * length),
          static_cast<double>(border.line_pairs) / length,
          region.inradius / drawing.diagonal,
          standard_deviation(region)};
}

double one_part_odds(const RegionMerging& regions, const DrawingMeasure& drawing, int a, int b) {
  if (drawing.cut_out && is_transparent(regions.region(a)) != is_transparent(regions.region(b)))
    return -certain;
  return sum_of_leaves(one_part_trees, features_of(regions, drawing, a, b));
}

double figure_odds(const RegionMerging& regions, const DrawingMeasure& drawing, int r) {
  if (drawing.cut_out) return is_transparent(regions.region(r)) ? -certain : certain;
  return sum_of_leaves(figure_trees, features_of(regions, drawing, r));
}

}  // namespace relievo::understanding
