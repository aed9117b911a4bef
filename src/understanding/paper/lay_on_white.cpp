#include "understanding/paper/lay_on_white.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/components.h"
#include "kernel/image/compose.h"
#include "kernel/image/mask.h"
#include "understanding/paper/paper_light.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

constexpr int fit_rounds = 12;        ///< rounds of reweighting at most; weights settle in about 8
constexpr double dark_step = 3;       ///< of 255; darker cells than the light may be ink or paint
constexpr double dark_weight = 0.02;  ///< weight of such cells; that of others is 1
/// Share of the paint that dividing by the light makes white at most; more means that the light was
/// fitted to the paint.
constexpr double erased_share = 0.06;
constexpr float darkest_paper = 40;  ///< least light that is divided out, of 255

/// Drops the alpha of an opaque picture.
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

/// Composites a picture, inverted if need be, over white.
Image8 composite_on_white(const Image8& rgba, bool invert) {
  const uint8_t flip = invert ? 255 : 0;
  Image8 rgb(rgba.width, rgba.height, 3);
  const uint8_t* in = rgba.pixels.data();
  for (uint8_t* out = rgb.pixels.data(); out != rgb.pixels.data() + rgb.pixels.size(); in += 4) {
    const int alpha = in[3];
    for (int c = 0; c < 3; ++c) *out++ = on_paper(in[c] ^ flip, alpha);
  }
  return rgb;
}

/// Fits the light on the paper in one channel by iteratively reweighted least squares: cells that
/// are darker than the light hardly count.
Quadratic light_on_paper(const Image8& cells, const std::vector<Quadratic>& terms, int channel) {
  std::vector<double> weights(terms.size(), 1);
  Quadratic light = fit_light(cells, terms, channel, weights);
  for (int round = 1; round < fit_rounds; ++round) {
    std::vector<double> next;
    for (size_t k = 0; k < terms.size(); ++k) {
      const double value = cells.pixels[k * cells.channels + channel];
      next.push_back(value < terms[k].dot(light) - dark_step ? dark_weight : 1);
    }
    if (next == weights) break;
    weights = std::move(next);
    light = fit_light(cells, terms, channel, weights);
  }
  return light;
}

bool is_white(const Quadratic& light) {
  return light[0] > 250 && light.tail<5>().cwiseAbs().maxCoeff() < 3;
}

/// Computes the factors of the pixels of one row of a channel, 255 over the light. `u` and `v` are
/// their coordinates from -1 to 1.
void scale_of_row(const Quadratic& light, double v, const std::vector<float>& u,
                  std::vector<float>& scale) {
  const auto constant = static_cast<float>(light[0] + light[2] * v + light[5] * v * v);
  const auto linear = static_cast<float>(light[1] + light[4] * v);
  const auto square = static_cast<float>(light[3]);
  for (size_t x = 0; x < u.size(); ++x) scale[x] = constant + (linear + square * u[x]) * u[x];
  // The light is extrapolated where paint covers the paper, and may be brighter than white there.
  for (float& value : scale) value = std::clamp(value, darkest_paper, 255.0F);
  for (float& value : scale) value = 255 / value;
}

/// Divides the channels by their light. White light changes nothing.
void divide_by(Image8& rgb, const Light& lights) {
  const auto width = static_cast<size_t>(rgb.width);
  std::vector<float> u(width);
  for (size_t x = 0; x < width; ++x)
    u[x] = static_cast<float>(light_terms(static_cast<int>(x), 0, rgb.width, rgb.height)[1]);
  std::vector<float> scale(width);
  std::vector<float> scales(3 * width, 1.0F);
  for (int y = 0; y < rgb.height; ++y) {
    const double v = light_terms(0, y, rgb.width, rgb.height)[2];
    for (size_t c = 0; c < 3; ++c) {
      if (is_white(lights[c])) continue;
      scale_of_row(lights[c], v, u, scale);
      for (size_t x = 0; x < width; ++x) scales[3 * x + c] = scale[x];
    }
    uint8_t* value = &rgb.at(0, y);
    for (size_t i = 0; i < scales.size(); ++i)
      value[i] =
          static_cast<uint8_t>(static_cast<int>(std::min(255.0F, value[i] * scales[i] + 0.5F)));
  }
}

/// Returns whether a good part of a picture's paint is white in `lit`.
bool erases_paint(const Image8& rgb, const Image8& lit) {
  const int64_t paint = pixel_count(tinted_pixels(rgb));
  const int64_t erased = paint - pixel_count(tinted_pixels(lit));
  return static_cast<double>(erased) > erased_share * static_cast<double>(paint);
}

}  // namespace

Image8 lay_on_white(const Image8& rgba, bool on_pure_white) {
  assert(rgba.channels == 4);
  const uint8_t alpha = least_alpha(rgba);
  const bool transparent = alpha < 128;
  Image8 rgb =
      alpha == 255 ? drop_alpha(rgba) : composite_on_white(rgba, is_light_on_nothing(rgba));
  if (rgb.empty() || transparent) return rgb;
  const Image8 cells = light_cells(rgb);
  const std::vector<Quadratic> terms = light_terms(cells);
  Light lights;
  for (int c = 0; c < 3; ++c) lights[c] = light_on_paper(cells, terms, c);
  if (std::all_of(lights.begin(), lights.end(), is_white)) return rgb;
  Image8 lit = rgb;
  divide_by(lit, lights);
  return on_pure_white && erases_paint(rgb, lit) ? rgb : lit;
}

}  // namespace relievo::understanding
