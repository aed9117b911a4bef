#include "kernel/image/compose.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace relievo {
namespace {

constexpr int colour_margin = 3;  ///< least distance from another label, px

/// A sum of colours on white and the number of its pixels.
struct ColourSum {
  std::array<double, 3> sum = {};
  double pixels = 0;

  void add(const uint8_t* rgba) {
    for (size_t c = 0; c < 3; ++c) sum[c] += on_paper(rgba[c], rgba[3]);
    ++pixels;
  }
};

/// Returns whether those of the four pixels at the margin's distance that lie in the picture have
/// the same label.
bool is_inside(const Image16& labels, int x, int y) {
  const uint16_t own = labels.at(x, y);
  const auto same = [&](int u, int v) {
    return u < 0 || v < 0 || u >= labels.width || v >= labels.height || labels.at(u, v) == own;
  };
  return same(x - colour_margin, y) && same(x + colour_margin, y) && same(x, y - colour_margin) &&
         same(x, y + colour_margin);
}

}  // namespace

void lay_over(uint8_t* below, const uint8_t* above, double opacity) {
  const double a = opacity * above[3] / 255;
  if (a <= 0) return;
  const double b = below[3] / 255.0 * (1 - a);
  for (int k = 0; k < 3; ++k)
    below[k] = static_cast<uint8_t>(std::lround((a * above[k] + b * below[k]) / (a + b)));
  below[3] = static_cast<uint8_t>(std::lround(255 * (a + b)));
}

void lay_picture_over(Image8& below, int left, int top, const Image8& above, double opacity) {
  for (int y = 0; y < above.height; ++y)
    for (int x = 0; x < above.width; ++x)
      lay_over(&below.at(left + x, top + y), &above.at(x, y), opacity);
}

uint8_t least_alpha(const Image8& rgba) {
  uint8_t least = 255;
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    least = rgba.pixels[i] < least ? rgba.pixels[i] : least;
  return least;
}

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

std::vector<std::array<double, 3>> label_colours(const Image8& rgba, const Image16& labels) {
  assert(rgba.channels == 4 && rgba.width == labels.width && rgba.height == labels.height);
  if (labels.empty()) return {};
  const size_t count = size_t{*std::max_element(labels.pixels.begin(), labels.pixels.end())} + 1;
  std::vector<ColourSum> inside(count);
  std::vector<ColourSum> whole(count);
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) {
      const uint16_t label = labels.at(x, y);
      whole[label].add(&rgba.at(x, y));
      if (is_inside(labels, x, y)) inside[label].add(&rgba.at(x, y));
    }
  std::vector<std::array<double, 3>> colours(count);
  for (size_t label = 0; label < count; ++label) {
    const ColourSum& used = inside[label].pixels > 0 ? inside[label] : whole[label];
    for (size_t c = 0; c < 3; ++c) colours[label][c] = used.sum[c] / std::max(used.pixels, 1.0);
  }
  return colours;
}

}  // namespace relievo
