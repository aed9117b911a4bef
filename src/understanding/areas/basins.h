#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"
#include "understanding/figure/figure_mask.h"

namespace relievo::understanding {

/// An area around a place that is farther from all lines than what lies around it.
struct Basin {
  int64_t area = 0;                        ///< px
  double inradius = 0;                     ///< largest distance to a line, px
  std::array<int64_t, 4> at_edge = {};     ///< px off the lines at the left, right, top, bottom
  Box2 box;                                ///< of its pixels
  std::array<int64_t, 3> colour_sum = {};  ///< of the drawing on white, over pixels off the lines
  int64_t coloured = 0;                    ///< pixels in colour_sum
  int64_t transparent = 0;                 ///< of those, the ones that are so in the drawing
  int64_t in_figure = 0;                   ///< pixels inside the figure's mask
};

/// Whether most of it is inside the figure's mask.
inline bool is_in_figure(const Basin& basin) { return 2 * basin.in_figure > basin.area; }

/// Where two basins meet.
struct BasinBorder {
  int a = 0;               ///< basin index, < b
  int b = 0;               ///< basin index
  int64_t pairs = 0;       ///< pairs of pixels that share a side across the border
  int64_t line_pairs = 0;  ///< of those, where one lies on a line
  int64_t edge_pairs = 0;  ///< of the others, where one lies on an edge between colours
  int64_t weight = 0;      ///< what LazyBrush pays for parting them
  /// Sum over the pairs without line and edge: the colour beside them in b less that in a.
  std::array<int64_t, 3> step = {};
};

/// A drawing divided into basins, each inside one area of the drawing as far as lines tell. What a
/// scribble can change starts here.
struct Basins {
  Image<int32_t> index;  ///< [drawing size] basin of every pixel, 0 ... #B - 1; lines are shared
  std::vector<Basin> basins;
  std::vector<BasinBorder> borders;  ///< sorted by a, b
  Image8 ink;                        ///< see LineMap
  Image8 barrier;                    ///< see LineMap
  FigureMask figure;                 ///< see find_figure
  double line_width = 1;             ///< px
  bool painted = false;              ///< see LineMap
  std::vector<int> region;           ///< [#B] proposal: 0 background, else 1 ... #R
  int region_count = 0;              ///< #R
  double unbounded_ink = 0;          ///< share of the lines, by area, that bound no region
};

/// LazyBrush's unit of cost K, what a pixel of white border costs: the perimeter of the image, so
/// that no cut through white is cheaper than a way round along ink (Sykora, Dingliana, Collins
/// 2009).
inline int64_t white_cost(int width, int height) { return 2 * (int64_t{width} + height); }

}  // namespace relievo::understanding
