#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo::understanding {

/// Light that changes slowly over one channel: the coefficients of 1, x, y, x^2, xy and y^2, where
/// x and y run from -1 to 1 across the picture.
using Quadratic = Eigen::Matrix<double, 6, 1>;

/// The light in red, green and blue, 0 to 255.
using Light = std::array<Quadratic, 3>;

/// Returns 1, x, y, x^2, xy and y^2 at a pixel.
Quadratic light_terms(int x, int y, int width, int height);

/// Returns the terms of all cells of a picture, row by row.
std::vector<Quadratic> light_terms(const Image8& cells);

/// Shrinks a picture to the cells to which light is fitted: their means, at most 48 along the
/// longer side. O(values).
Image8 light_cells(const Image8& picture);

/// Fits light to one channel of the cells by weighted least squares. `terms` are those of all
/// cells, and `weights` has one number for each. O(cells).
Quadratic fit_light(const Image8& cells, const std::vector<Quadratic>& terms, int channel,
                    const std::vector<double>& weights);

}  // namespace relievo::understanding
