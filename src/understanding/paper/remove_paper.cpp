#include "understanding/paper/remove_paper.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/compose.h"
#include "understanding/paper/paper_light.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

constexpr int fit_rounds = 12;         ///< of reweighting at most; weights settle in about eight
constexpr double dark_weight = 0.02;   ///< of cells below the fit, which may be ink or paint
constexpr double erased_share = 0.06;  ///< of the paint, from which on the light is that on paint
constexpr float darkest_paper = 40;    ///< light below which nothing is divided out

double position(int i, int n) { return n < 2 ? 0 : 2.0 * i / (n - 1) - 1; }

/// An opaque picture without its alpha.
Image8 drop_alpha(const Image8& rgba) {
  Image8 rgb(rgba.width, rgba.height, 3);
  const uint8_t* in = rgba.pixels.data();
  uint8_t* out = rgb.pixels.data();
  for (size_t left = rgba.pixels.size() / 4; left > 0; --left, in += 4, out += 3) {
    out[0] = in[0];
    out[1] = in[1];
    out[2] = in[2];
  }
  return rgb;
}

Image8 lay_on_white(const Image8& rgba, bool invert) {
  const uint8_t flip = invert ? 255 : 0;
  Image8 rgb(rgba.width, rgba.height, 3);
  const uint8_t* in = rgba.pixels.data();
  for (uint8_t* out = rgb.pixels.data(); out != rgb.pixels.data() + rgb.pixels.size(); in += 4) {
    const int alpha = in[3];
    for (int c = 0; c < 3; ++c) *out++ = on_paper(in[c] ^ flip, alpha);
  }
  return rgb;
}

/// The light on the paper in one channel: a fit that hardly minds what lies far below it.
Quadratic light_on_paper(const LightCells& cells, int channel) {
  std::vector<double> weights(cells.terms.size(), 1);
  Quadratic light = fit_light(cells, channel, weights);
  for (int round = 1; round < fit_rounds; ++round) {
    std::vector<double> next;
    for (size_t k = 0; k < cells.terms.size(); ++k) {
      const double value = cells.mean.pixels[k * cells.mean.channels + channel];
      next.push_back(value < cells.terms[k].dot(light) - 3 ? dark_weight : 1);
    }
    if (next == weights) break;
    weights = std::move(next);
    light = fit_light(cells, channel, weights);
  }
  return light;
}

bool is_white(const Quadratic& light) {
  return light[0] > 250 && light.tail<5>().cwiseAbs().maxCoeff() < 3;
}

/// What the pixels of one row of a channel are multiplied with, 255 over the light.
void scale_of_row(const Quadratic& light, double v, const std::vector<float>& u,
                  std::vector<float>& scale) {
  const auto constant = static_cast<float>(light[0] + light[2] * v + light[5] * v * v);
  const auto linear = static_cast<float>(light[1] + light[4] * v);
  const auto square = static_cast<float>(light[3]);
  for (size_t x = 0; x < u.size(); ++x) scale[x] = constant + (linear + square * u[x]) * u[x];
  // Where paint covers the paper the fit is a guess, which may be brighter than white.
  for (float& value : scale) value = std::clamp(value, darkest_paper, 255.0F);
  for (float& value : scale) value = 255 / value;
}

/// Divides the channels by the light on them; white light changes nothing.
void divide_by(Image8& rgb, const Light& lights) {
  const auto width = static_cast<size_t>(rgb.width);
  std::vector<float> u(width);
  for (size_t x = 0; x < width; ++x)
    u[x] = static_cast<float>(position(static_cast<int>(x), rgb.width));
  std::vector<float> scale(width);
  std::vector<float> scales(3 * width, 1.0F);
  for (int y = 0; y < rgb.height; ++y) {
    for (size_t c = 0; c < 3; ++c) {
      if (is_white(lights[c])) continue;
      scale_of_row(lights[c], position(y, rgb.height), u, scale);
      for (size_t x = 0; x < width; ++x) scales[3 * x + c] = scale[x];
    }
    uint8_t* value = &rgb.at(0, y);
    for (size_t i = 0; i < scales.size(); ++i)
      value[i] =
          static_cast<uint8_t>(static_cast<int>(std::min(255.0F, value[i] * scales[i] + 0.5F)));
  }
}

int64_t paint_pixels(const Image8& rgb) {
  const Image8 paint = tinted_pixels(rgb);
  return std::count(paint.pixels.begin(), paint.pixels.end(), 1);
}

/// Whether a good part of the paint in a picture is white where the light on it is divided out.
bool erases_paint(const Image8& rgb, const Image8& lit) {
  const int64_t paint = paint_pixels(rgb);
  const int64_t erased = paint - paint_pixels(lit);
  return static_cast<double>(erased) > erased_share * static_cast<double>(paint);
}

}  // namespace

Image8 remove_paper(const Image8& rgba, bool on_pure_white) {
  assert(rgba.channels == 4);
  const uint8_t alpha = least_alpha(rgba);
  const bool transparent = alpha < 128;
  Image8 rgb = alpha == 255 ? drop_alpha(rgba) : lay_on_white(rgba, is_light_on_nothing(rgba));
  if (rgb.empty() || transparent) return rgb;
  const LightCells cells = light_cells(rgb);
  Light lights;
  for (int c = 0; c < 3; ++c) lights[c] = light_on_paper(cells, c);
  if (std::all_of(lights.begin(), lights.end(), is_white)) return rgb;
  Image8 lit = rgb;
  divide_by(lit, lights);
  return on_pure_white && erases_paint(rgb, lit) ? rgb : lit;
}

}  // namespace relievo::understanding
