#include "relief/drawing/remove_paper.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "kernel/image/blur.h"

namespace relievo {
namespace {

constexpr int fit_side = 48;          ///< cells along the longer side that the light is fitted to
constexpr int fit_rounds = 12;        ///< of reweighting; the weights settle in about eight
constexpr double dark_weight = 0.02;  ///< of cells below the fit, which may be ink or paint
constexpr float darkest_paper = 40;   ///< light below which nothing is divided out

/// Whether the opaque pixels are light and few: lines meant for a dark ground.
bool is_light_on_nothing(const Image8& rgba) {
  int64_t opaque = 0;
  int64_t light = 0;
  for (size_t i = 0; i < rgba.pixels.size(); i += 4) {
    if (rgba.pixels[i + 3] < 128) continue;
    ++opaque;
    light += std::min({rgba.pixels[i], rgba.pixels[i + 1], rgba.pixels[i + 2]}) > 200 ? 1 : 0;
  }
  const auto pixels = static_cast<int64_t>(rgba.pixels.size() / 4);
  return opaque < pixels / 4 && light > opaque * 9 / 10;
}

bool has_transparency(const Image8& rgba) {
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    if (rgba.pixels[i] < 128) return true;
  return false;
}

Image8 composite(const Image8& rgba, bool invert) {
  const uint8_t flip = invert ? 255 : 0;
  Image8 rgb(rgba.width, rgba.height, 3);
  const uint8_t* in = rgba.pixels.data();
  for (uint8_t* out = rgb.pixels.data(); out != rgb.pixels.data() + rgb.pixels.size(); in += 4) {
    const uint32_t alpha = in[3];
    for (int c = 0; c < 3; ++c) {
      const auto value = static_cast<uint8_t>(in[c] ^ flip);
      *out++ = alpha == 255
                   ? value
                   : static_cast<uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
    }
  }
  return rgb;
}

using Quadratic = Eigen::Matrix<double, 6, 1>;

/// Terms of a quadratic at x, y in [-1, 1].
Quadratic terms(double x, double y) {
  Quadratic t;
  t << 1, x, y, x * x, x * y, y * y;
  return t;
}

double position(int i, int n) { return n < 2 ? 0 : 2.0 * i / (n - 1) - 1; }

/// The light on the paper in one channel: a fit that hardly minds what lies far below it.
Quadratic fit_light(const Image8& cells, int channel) {
  Quadratic light = Quadratic::Zero();
  for (int round = 0; round < fit_rounds; ++round) {
    Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
    Quadratic b = Quadratic::Zero();
    for (int y = 0; y < cells.height; ++y)
      for (int x = 0; x < cells.width; ++x) {
        const Quadratic t = terms(position(x, cells.width), position(y, cells.height));
        const double value = cells.at(x, y, channel);
        const double weight = round > 0 && value < t.dot(light) - 3 ? dark_weight : 1;
        A += weight * t * t.transpose();
        b += weight * value * t;
      }
    light = A.ldlt().solve(b);
  }
  return light;
}

bool is_white(const Quadratic& light) {
  return light[0] > 250 && light.tail<5>().cwiseAbs().maxCoeff() < 3;
}

/// What one row of a channel is multiplied with, into every third value.
void scale_of_row(const Quadratic& light, double v, const std::vector<float>& u, float* scale) {
  const auto constant = static_cast<float>(light[0] + light[2] * v + light[5] * v * v);
  const auto linear = static_cast<float>(light[1] + light[4] * v);
  const auto square = static_cast<float>(light[3]);
  for (size_t x = 0; x < u.size(); ++x)
    scale[3 * x] = 255 / std::max(darkest_paper, constant + (linear + square * u[x]) * u[x]);
}

/// Divides the channels by the light on them; white light changes nothing.
void divide_by(Image8& rgb, const std::array<Quadratic, 3>& lights) {
  std::vector<float> u(static_cast<size_t>(rgb.width));
  for (int x = 0; x < rgb.width; ++x) u[x] = static_cast<float>(position(x, rgb.width));
  std::vector<float> scale(3 * u.size(), 1.0F);
  for (int y = 0; y < rgb.height; ++y) {
    for (size_t c = 0; c < 3; ++c)
      if (!is_white(lights[c])) scale_of_row(lights[c], position(y, rgb.height), u, &scale[c]);
    uint8_t* value = &rgb.at(0, y);
    for (size_t i = 0; i < scale.size(); ++i)
      value[i] =
          static_cast<uint8_t>(static_cast<int>(std::min(255.0F, value[i] * scale[i] + 0.5F)));
  }
}

}  // namespace

Image8 remove_paper(const Image8& rgba) {
  assert(rgba.channels == 4);
  const bool transparent = has_transparency(rgba);
  Image8 rgb = composite(rgba, transparent && is_light_on_nothing(rgba));
  if (rgb.empty() || transparent) return rgb;
  const int factor = (std::max(rgb.width, rgb.height) + fit_side - 1) / fit_side;
  const Image8 cells = shrink(rgb, factor);
  std::array<Quadratic, 3> lights;
  for (int c = 0; c < 3; ++c) lights[c] = fit_light(cells, c);
  if (!std::all_of(lights.begin(), lights.end(), is_white)) divide_by(rgb, lights);
  return rgb;
}

}  // namespace relievo
