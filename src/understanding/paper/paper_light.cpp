#include "understanding/paper/paper_light.h"

#include <algorithm>

#include "kernel/image/blur.h"

namespace relievo::understanding {
namespace {

constexpr int fit_side = 48;  ///< cells along the longer side that the light is fitted to

double position(int i, int n) { return n < 2 ? 0 : 2.0 * i / (n - 1) - 1; }

}  // namespace

Quadratic light_terms(int x, int y, int width, int height) {
  const double u = position(x, width);
  const double v = position(y, height);
  Quadratic t;
  t << 1, u, v, u * u, u * v, v * v;
  return t;
}

LightCells light_cells(const Image8& picture) {
  const int factor = (std::max(picture.width, picture.height) + fit_side - 1) / fit_side;
  LightCells cells{shrink(picture, factor), {}};
  const int width = cells.mean.width;
  const int height = cells.mean.height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) cells.terms.push_back(light_terms(x, y, width, height));
  return cells;
}

Quadratic fit_light(const LightCells& cells, int channel, const std::vector<double>& weights) {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
  Quadratic b = Quadratic::Zero();
  for (size_t k = 0; k < cells.terms.size(); ++k) {
    const Quadratic& terms = cells.terms[k];
    const double value = cells.mean.pixels[k * cells.mean.channels + channel];
    b += weights[k] * value * terms;
    for (int j = 0; j < 6; ++j)
      for (int i = j; i < 6; ++i) A(i, j) += weights[k] * terms[i] * terms[j];
  }
  return A.ldlt().solve(b);
}

uint8_t least_alpha(const Image8& rgba) {
  uint8_t least = 255;
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    least = rgba.pixels[i] < least ? rgba.pixels[i] : least;
  return least;
}

}  // namespace relievo::understanding
