#pragma once

#include <cstddef>

namespace relievo {

struct SvgOptions {
  /// Largest distance of a flattened curve from the true one, canvas px.
  double tolerance = 0.1;
  /// The canvas is the viewport of the root element, px. If its longest side is outside [min_side,
  /// max_side], it is scaled so that this side becomes scaled_side.
  double min_side = 400;
  double max_side = 4096;
  double scaled_side = 1000;

  size_t max_bytes = size_t{32} << 20;  ///< of the file
  size_t max_elements = 100000;         ///< in the file, and again after `use` is expanded
  size_t max_depth = 128;               ///< of nesting, `use` included
  size_t max_points = 1000000;          ///< of all flattened outlines together
  double max_tangle = 2e6;              ///< of a shape (see tangle); a worse one is left out
  double max_total_tangle = 3e7;        ///< of all shapes together
};

}  // namespace relievo
