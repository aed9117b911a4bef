#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo::understanding {

/// Slowly changing light in one channel: the factors of 1, x, y, x^2, xy and y^2 at x and y from -1
/// to 1 across a picture.
using Quadratic = Eigen::Matrix<double, 6, 1>;

/// The light in each channel, 0 to 255.
using Light = std::array<Quadratic, 3>;

/// 1, x, y, x^2, xy and y^2 at a pixel.
Quadratic light_terms(int x, int y, int width, int height);

/// A picture in a few cells.
struct LightCells {
  Image8 mean;                   ///< its channels
  std::vector<Quadratic> terms;  ///< [cells, row by row]
};

/// O(values).
LightCells light_cells(const Image8& picture);

/// The quadratic of least squares through one channel. `weights` are of the cells. O(cells).
Quadratic fit_light(const LightCells& cells, int channel, const std::vector<double>& weights);

/// O(pixels).
uint8_t least_alpha(const Image8& rgba);

}  // namespace relievo::understanding
