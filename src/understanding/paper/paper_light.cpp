#include "understanding/paper/paper_light.h"

#include <algorithm>

#include "kernel/image/blur.h"

namespace relievo::understanding {
namespace {

constexpr int fit_side = 48;  ///< cells along the picture's longer side, at most

double position(int i, int n) { return n < 2 ? 0 : 2.0 * i / (n - 1) - 1; }

}  // namespace

Quadratic light_terms(int x, int y, int width, int height) {
  const double u = position(x, width);
  const double v = position(y, height);
  Quadratic t;
  t << 1, u, v, u * u, u * v, v * v;
  return t;
}

std::vector<Quadratic> light_terms(const Image8& cells) {
  std::vector<Quadratic> terms;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x)
      terms.push_back(light_terms(x, y, cells.width, cells.height));
  return terms;
}

Image8 light_cells(const Image8& picture) {
  return shrink(picture, (std::max(picture.width, picture.height) + fit_side - 1) / fit_side);
}

/// With the terms t_k, values v_k and weights w_k of the cells, solves the normal equations
///   (sum_k w_k t_k t_k^T + 1e-9 I) light = sum_k w_k v_k t_k.
Quadratic fit_light(const Image8& cells, const std::vector<Quadratic>& terms, int channel,
                    const std::vector<double>& weights) {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
  Quadratic b = Quadratic::Zero();
  for (size_t k = 0; k < terms.size(); ++k) {
    const Quadratic& t = terms[k];
    const double value = cells.pixels[k * cells.channels + channel];
    b += weights[k] * value * t;
    for (int j = 0; j < 6; ++j)
      for (int i = j; i < 6; ++i) A(i, j) += weights[k] * t[i] * t[j];
  }
  return A.ldlt().solve(b);
}

}  // namespace relievo::understanding
