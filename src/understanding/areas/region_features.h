#pragma once

#include <array>

#include "understanding/areas/region_merging.h"

namespace relievo::understanding {

/// The measures of two neighbouring regions, of which the first is the smaller one. The tables
/// that research/learning/regions.py writes depend on this order.
enum class PairFeature {
  contour,        ///< mean probability of a contour on their border
  near_contour,   ///< mean of the greatest such probability nearby
  on_contour,     ///< share of the border near which a contour is likelier than not
  line,           ///< share of the border on lines
  edge,           ///< share of the border on edges between colours
  ink,            ///< mean ink on the border
  colour_step,    ///< distance of the colours beside the border, of 255 a channel
  colour,         ///< distance of the mean colours, of 255 a channel
  smaller_area,   ///< logarithm of the area, per figure
  larger_area,    ///< the same of the larger region
  smaller_share,  ///< share of the smaller region's border that is common
  larger_share,   ///< the same of the larger region
  figure_step,    ///< difference of the mean probabilities of the figure
  least_figure,   ///< the lesser of these
  inradius,       ///< the lesser inradius, per diagonal of the picture
  texture,        ///< the greater standard deviation of colours, of 255
  length,         ///< length of the border, per diagonal of the picture
  count
};

/// The measures of a region, likewise.
enum class RegionFeature {
  figure,    ///< mean probability that a pixel belongs to the figure
  around,    ///< the same beyond its border
  at_edge,   ///< share of its border at the edge of the picture
  edges,     ///< number of the picture's edges that it reaches
  area,      ///< logarithm of its share of the picture
  paper,     ///< distance of its mean colour from that of the picture's edge, of 255 a channel
  contour,   ///< mean of the greatest probability of a contour near its border
  line,      ///< share of its border on lines
  inradius,  ///< per diagonal of the picture
  texture,   ///< standard deviation of its colours, of 255
  count
};

using PairFeatures = std::array<double, static_cast<size_t>(PairFeature::count)>;
using RegionFeatures = std::array<double, static_cast<size_t>(RegionFeature::count)>;

/// Measures of a whole drawing, to which those of its regions are compared.
struct DrawingMeasure {
  double figure = 1;                 ///< area of the figure, px
  double picture = 1;                ///< area of the picture, px
  double diagonal = 1;               ///< of the picture, px
  bool cut_out = false;              ///< see is_cut_out
  std::array<double, 3> paper = {};  ///< mean colour at the picture's edge, 0 to 255
};

DrawingMeasure measure_drawing(const Basins& basins);

/// Measures two neighbours. O(their neighbours).
PairFeatures features_of(const RegionMerging& regions, const DrawingMeasure& drawing, int a, int b);

/// Measures a region. O(its neighbours).
RegionFeatures features_of(const RegionMerging& regions, const DrawingMeasure& drawing, int r);

/// Computes the log-odds that two neighbours belong to one part, from drawings with known parts. In
/// a cut-out, a transparent and an opaque one never do.
double one_part_odds(const RegionMerging& regions, const DrawingMeasure& drawing, int a, int b);

/// Computes the log-odds that a region belongs to the figure, likewise. In a cut-out, the
/// opaque ones do.
double figure_odds(const RegionMerging& regions, const DrawingMeasure& drawing, int r);

}  // namespace relievo::understanding
