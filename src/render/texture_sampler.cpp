#include "render/texture_sampler.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
namespace {

std::array<double, 256> linear_values() {
  std::array<double, 256> values;
  for (size_t i = 0; i < values.size(); ++i) values[i] = to_linear(static_cast<double>(i) / 255);
  return values;
}

Image8 halved(const Image8& image, const std::array<double, 256>& linear) {
  Image8 half(std::max(1, image.width / 2), std::max(1, image.height / 2), image.channels);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < image.channels; ++c) {
        double sum = 0;
        for (int k = 0; k < 4; ++k)
          sum += linear[image.at(std::min(2 * x + k % 2, image.width - 1),
                                 std::min(2 * y + k / 2, image.height - 1), c)];
        half.at(x, y, c) = static_cast<uint8_t>(std::lround(255 * to_srgb(sum / 4)));
      }
  return half;
}

}  // namespace

TextureSampler::TextureSampler(Image8 rgb, double max_width)
    : rgb_(std::move(rgb)), linear_(linear_values()) {
  while (rgb_.width >= 2 * max_width && rgb_.width > 1) rgb_ = halved(rgb_, linear_);
}

Rgb TextureSampler::pixel(int x, int y) const {
  x = std::clamp(x, 0, rgb_.width - 1);
  y = std::clamp(y, 0, rgb_.height - 1);
  return {linear_[rgb_.at(x, y, 0)], linear_[rgb_.at(x, y, 1)], linear_[rgb_.at(x, y, 2)]};
}

Rgb TextureSampler::at(Point2 uv) const {
  const double x = std::clamp(uv.x, 0.0, 1.0) * rgb_.width - 0.5;
  const double y = std::clamp(uv.y, 0.0, 1.0) * rgb_.height - 0.5;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const Rgb top = mix(pixel(x0, y0), pixel(x0 + 1, y0), x - x0);
  const Rgb bottom = mix(pixel(x0, y0 + 1), pixel(x0 + 1, y0 + 1), x - x0);
  return mix(top, bottom, y - y0);
}

}  // namespace relievo
