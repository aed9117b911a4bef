#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"
#include "understanding/perception/perceive.h"

namespace relievo::understanding {

/// Measurements of a basin: the area around a local maximum of the distance to lines and edges.
/// They are additive, so that they describe unions of basins too.
struct Basin {
  int64_t area = 0;                        ///< px
  double inradius = 0;                     ///< largest distance to a line, px
  std::array<int64_t, 4> at_edge = {};     ///< px off the lines at the left, right, top, bottom
  Box2 box;                                ///< around its pixels
  std::array<int64_t, 3> colour_sum = {};  ///< of the drawing on white, over its pixels off lines
  int64_t colour_squares = 0;              ///< of all channels, over the same pixels
  int64_t coloured = 0;                    ///< px in colour_sum
  int64_t transparent = 0;                 ///< px that are transparent in the drawing
  int64_t figure = 0;                      ///< sum of Perception::figure over its pixels
};

/// Computes the mean colour of a basin, of 255 a channel. Precondition: basin.coloured > 0.
inline std::array<double, 3> mean_colour(const Basin& basin) {
  std::array<double, 3> mean = {};
  for (size_t c = 0; c < 3; ++c)
    mean[c] = static_cast<double>(basin.colour_sum[c]) / static_cast<double>(basin.coloured);
  return mean;
}

/// The border between two areas, as sums over the pairs of pixels that share a side across it.
struct Border {
  int64_t pairs = 0;         ///< number of pairs
  int64_t line_pairs = 0;    ///< pairs with a pixel on a line
  int64_t edge_pairs = 0;    ///< other pairs with a pixel on an edge between colours
  int64_t ink = 0;           ///< sum of LineMap::ink, the greater of a pair
  int64_t contour = 0;       ///< sum of Perception::contour, the greater of a pair
  int64_t near_contour = 0;  ///< sum of the greatest Perception::contour nearby
  int64_t on_contour = 0;    ///< pairs near which a contour is likelier than not
  /// Sum of the colour near the border in the second area less that in the first.
  std::array<int64_t, 3> step = {};

  void add(const Border& other) {
    pairs += other.pairs;
    line_pairs += other.line_pairs;
    edge_pairs += other.edge_pairs;
    ink += other.ink;
    contour += other.contour;
    near_contour += other.near_contour;
    on_contour += other.on_contour;
    for (size_t c = 0; c < 3; ++c) step[c] += other.step[c];
  }
};

/// The border between basins `a` and `b`.
struct BasinBorder : Border {
  int a = 0;           ///< basin index, < b
  int b = 0;           ///< basin index
  int64_t weight = 0;  ///< cost of different labels in LazyBrush's energy
};

/// A drawing divided into basins, each inside one area of the drawing as far as its lines show.
/// Everything that scribbles change is computed from here.
struct Basins {
  Image<int32_t> index;  ///< [drawing size] basin of every pixel, 0 ... #B - 1; lines included
  std::vector<Basin> basins;
  std::vector<BasinBorder> borders;  ///< sorted by a, b
  Image8 ink;                        ///< see LineMap
  Image8 barrier;                    ///< see LineMap
  Image8 figure;                     ///< Perception::figure of every pixel
  Image8 contour;                    ///< Perception::contour of every pixel
  Image8 near_contour;               ///< the greatest of those nearby
  FrontMap front;                    ///< see Perception
  double line_width = 1;             ///< px
  bool cut_out = false;              ///< see is_cut_out
  std::vector<int> region;           ///< [#B] proposed region: 0 background, else 1 ... #R
  int region_count = 0;              ///< #R
  double unbounded_ink = 0;          ///< share of the lines, by area, that bound no region
};

/// Computes LazyBrush's constant K, the cost of a pixel of white border. It is the perimeter of the
/// image, so that a cut through white is never cheaper than a way around it along ink (Sykora,
/// Dingliana, Collins 2009).
inline int64_t white_cost(int width, int height) { return 2 * (int64_t{width} + height); }

}  // namespace relievo::understanding
